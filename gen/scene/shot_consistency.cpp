#include "scene/shot_consistency.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scene/calendar.h"
#include "scene/keys.h"
#include "scene/shots.h"
#include "scene/sun_path.h"
#include "scene/sun_position.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

using std::chrono::sys_days;
using Numbers = std::vector<std::int64_t>;

constexpr double day_s = 86400.0, hour_s = 3600.0;

bool is_day(const Numbers& date) { return date.size() == 3 && date_of(date).ok(); }

/// Whether the season's days are such that moments of it are known.
bool has_days(const Season& season) {
  return is_day(season.first) && is_day(season.last) &&
         date_of(season.first) < date_of(season.last);
}

class Judge {
 public:
  Judge(const Scene& scene, const Places& places, std::vector<Problem>& problems)
      : scene_(scene), places_(places), problems_(problems) {}

  void judge() const {
    if (!judge_length()) return;
    for (std::size_t item = 0; item < scene_.shots.size(); ++item) {
      judge_name(item);
      if (is_season(scene_)) {
        judge_in_season(item);
      } else {
        judge_without_season(item);
      }
    }
    judge_other_frames();
  }

 private:
  void judge_name(std::size_t item) const {
    const std::string& name = scene_.shots[item].name;
    for (std::size_t other = 0; other < item; ++other)
      if (scene_.shots[other].name == name)
        add(item, "name",
            fmt::format("found \"{}\", which {} has; expected a name of its own", name,
                        item_name("shots", other)));
  }

  void judge_without_season(std::size_t item) const {
    const Shot& shot = scene_.shots[item];
    if (!shot.date.empty())
      add(item, "date",
          "found a day, but the scene is no season; expected start, or season.first and "
          "season.last");
    if (shot.time_h)
      add(item, "time",
          "found an hour of the day, but the scene is no season; expected start, or season.first "
          "and season.last");
  }

  void judge_in_season(std::size_t item) const {
    const Shot& shot = scene_.shots[item];
    if (shot.start_s != Shot().start_s)
      add(item, "start", "found beside a season; expected date and time");
    if (!shot.weathering.empty())
      add(item, "weathering",
          "found beside a season, whose days say how the grass withers; expected no weathering, "
          "or weathering in [[season_keys]]");
    if (!is_day(shot.date)) {
      add(item, "date",
          fmt::format("found {}, expected a year, month and day of the calendar", shot.date));
    } else if (has_days(scene_.season) && judge_days(item)) {
      judge_sun(item);
    }
  }

  /// Whether all of it is within the season.
  bool judge_days(std::size_t item) const {
    const Shot& shot = scene_.shots[item];
    const Season& season = scene_.season;
    if (date_of(shot.date) < date_of(season.first) || date_of(shot.date) > date_of(season.last)) {
      add(item, "date",
          fmt::format("found {}, expected a day of the season, from {} to {}", shot.date,
                      season.first, season.last));
      return false;
    }
    const int frames = frame_count(scene_, shot);
    const double hours = shot.time_h.value_or(scene_.sun.time_h);
    const double days_left = static_cast<double>(
        (sys_days(date_of(season.last)) - sys_days(date_of(shot.date))).count() + 1);
    const double left_s = days_left * day_s - hours * hour_s;
    const double length_s = (frames - 1) * shot.frame_seconds;
    if (length_s <= left_s) return true;
    add(item, "frame_seconds",
        fmt::format("found {} s, by which its {} frames last {:.1f} days; expected at most {:.1f} "
                    "days, to the end of season.last ({})",
                    shot.frame_seconds, frames, length_s / day_s, left_s / day_s, season.last));
    return false;
  }

  /// It is day or dusk in all of its frames.
  void judge_sun(std::size_t item) const {
    const Take take = takes_of(scene_)[item];
    int lowest = take.first;
    double lowest_deg = 90.0;
    for (int frame = take.first; frame <= take.last(); ++frame)
      if (const double now_deg = sun_of_frame(scene_, frame).elevation_deg; now_deg < lowest_deg) {
        lowest = frame;
        lowest_deg = now_deg;
      }
    if (lowest_deg >= min_sun_elevation_deg) return;
    const double hours = scene_.shots[item].time_h.value_or(scene_.sun.time_h);
    add(item, "time",
        fmt::format("found {} h of universal time, by which the sun stands at {:.1f} degrees in "
                    "its frame {} of {}; expected a time of day, seconds and frame_seconds by "
                    "which it stands at {} degrees at least",
                    hours, lowest_deg, lowest - take.first + 1, take.count, min_sun_elevation_deg));
  }

  /// Whether the film has no more frames than a film may have.
  bool judge_length() const {
    int frames = 0;
    for (std::size_t item = 0; item < scene_.shots.size(); ++item) {
      frames += frame_count(scene_, scene_.shots[item]);
      if (frames <= max_film_frames) continue;
      add(item, "seconds",
          fmt::format("found {} s, by which the film has {} frames; expected at most {}",
                      scene_.shots[item].seconds, frames, max_film_frames));
      return false;
    }
    return true;
  }

  /// A scene that has been read and written says of its frames what its shots say.
  void judge_other_frames() const {
    if (scene_.shots.empty()) return;
    const int frames = frame_count(scene_);
    const std::vector<double>& degrees = scene_.ageing.frames;
    const bool same = is_season(scene_) ? static_cast<int>(degrees.size()) == frames
                                        : degrees == weathering_of_shots(scene_);
    if (!same) add_overlap("ageing.frames", fmt::format("{} degrees", degrees.size()), frames);
    if (scene_.season.frames != frames)
      add_overlap("season.frames", fmt::format("{}", scene_.season.frames), frames);
  }

  void add_overlap(const std::string& key, const std::string& found, int frames) const {
    const auto given = places_.given.find(key);
    if (given == places_.given.end() || places_.failed.count(key) > 0) return;
    problems_.push_back(
        {given->second, fmt::format("{}: found {} beside [[shots]], which have {} frames of their "
                                    "own (seconds times film.frames_per_second); expected one of "
                                    "the two: take {} out, or [[shots]]",
                                    key, found, frames, key)});
  }

  /// At the key, else at the shot.
  void add(std::size_t item, const char* leaf, const std::string& message) const {
    const std::string name = item_name("shots", item);
    const std::string key = fmt::format("{}.{}", name, leaf);
    if (places_.failed.count(key) > 0) return;
    SourcePosition where;
    for (const std::string& place : {name, key})
      if (const auto given = places_.given.find(place); given != places_.given.end())
        where = given->second;
    problems_.push_back({where, fmt::format("{}: {}", key, message)});
  }

  const Scene& scene_;
  const Places& places_;
  std::vector<Problem>& problems_;
};

}  // namespace

void report_shot_contradictions(const Scene& scene, const Places& places,
                                std::vector<Problem>& problems) {
  Judge(scene, places, problems).judge();
}

}  // namespace wold::scene
