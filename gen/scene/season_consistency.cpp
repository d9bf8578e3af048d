#include "scene/season_consistency.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/calendar.h"
#include "scene/registry.h"
#include "scene/sun_position.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

using std::chrono::sys_days;
using Numbers = std::vector<std::int64_t>;

/// Seasons are shorter than this: snow is reckoned hour by hour.
constexpr int max_days = 400;

bool is_day(const Numbers& date) { return date.size() == 3 && date_of(date).ok(); }

class Judge {
 public:
  Judge(const Scene& scene, const Places& places, std::vector<Problem>& problems)
      : scene_(scene), places_(places), problems_(problems) {}

  void judge() const {
    if (is_season(scene_)) {
      judge_days();
      judge_sources();
    } else if (!scene_.season.table.empty()) {
      add("season.table",
          "found the days of a season, but the scene is none; expected season.first and "
          "season.last");
    }
    judge_keys();
  }

 private:
  void judge_days() const {
    const Season& season = scene_.season;
    judge_day("season.first", season.first);
    judge_day("season.last", season.last);
    if (!is_day(season.first) || !is_day(season.last)) return;
    const auto days = (sys_days(date_of(season.last)) - sys_days(date_of(season.first))).count();
    if (days < 1 || days > max_days)
      add("season.last",
          fmt::format("found {}, expected a day after season.first ({}), at most {} later",
                      season.last, season.first, max_days));
    if (days >= 1 && days <= max_days && scene_.shots.empty())
      judge_sun(date_of(season.first), date_of(season.last));
  }

  void judge_day(const std::string& key, const Numbers& date) const {
    if (!is_day(date))
      add(key, fmt::format("found {}, expected a year, month and day of the calendar", date));
  }

  double sun_elevation_deg(sys_days day) const {
    const Sun& sun = scene_.sun;
    return sun_position(day, sun.time_h, sun.latitude_deg, sun.longitude_deg).elevation_deg;
  }

  /// On each of the days: the lowest sun may stand on any of them.
  void judge_sun(sys_days first, sys_days last) const {
    sys_days lowest = first;
    for (sys_days day = first; day <= last; day += std::chrono::days(1))
      if (sun_elevation_deg(day) < sun_elevation_deg(lowest)) lowest = day;
    const double elevation_deg = sun_elevation_deg(lowest);
    if (elevation_deg >= min_sun_elevation_deg) return;
    const std::chrono::year_month_day date(lowest);
    add("sun.time",
        fmt::format("found {} h of universal time, when the sun stands at {:.1f} degrees on "
                    "[{}, {}, {}],"
                    " expected a time of day when it stands at {} degrees at least all "
                    "season",
                    scene_.sun.time_h, elevation_deg, static_cast<int>(date.year()),
                    static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                    min_sun_elevation_deg));
  }

  void judge_sources() const {
    const std::string& table = scene_.season.table;
    const bool withers = std::ranges::any_of(
        scene_.season_keys, [](const SeasonKey& key) { return key.weathering.has_value(); });
    if (table.empty() && !withers)
      add("season.first",
          "found a season in which nothing says how the grass withers, expected season.table or "
          "[[season_keys]] with weathering");
  }

  void judge_keys() const {
    const std::vector<SeasonKey>& keys = scene_.season_keys;
    for (std::size_t item = 0; item < keys.size(); ++item) {
      const std::string name = item_name("season_keys", item);
      if (scene_.season.first.empty())
        add(name, "found a day of a season, but the scene is none; expected season.first");
      else if (!is_day(keys[item].date))
        add(name + ".date", fmt::format("found {}, expected a year, month and day of the calendar",
                                        keys[item].date));
      else if (item > 0 && is_day(keys[item - 1].date) &&
               date_of(keys[item].date) <= date_of(keys[item - 1].date))
        add(name + ".date", fmt::format("found {}, expected a day after {}, the one before",
                                        keys[item].date, keys[item - 1].date));
    }
  }

  /// At the key, else at the item that it belongs to, else where the season is begun.
  void add(const std::string& key, const std::string& message) const {
    if (places_.failed.count(key) > 0) return;
    SourcePosition where;
    for (const std::string& name : {std::string("season.first"), std::string(table_of(key)), key})
      if (const auto given = places_.given.find(name); given != places_.given.end())
        where = given->second;
    problems_.push_back({where, fmt::format("{}: {}", key, message)});
  }

  const Scene& scene_;
  const Places& places_;
  std::vector<Problem>& problems_;
};

}  // namespace

void report_season_contradictions(const Scene& scene, const Places& places,
                                  std::vector<Problem>& problems) {
  Judge(scene, places, problems).judge();
}

}  // namespace wold::scene
