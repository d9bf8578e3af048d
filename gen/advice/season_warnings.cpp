#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "advice/scene_warnings.h"
#include "scene/calendar.h"
#include "weather/daily_weather.h"

namespace wold::advice {
namespace {

using scene::SeasonKey;
using std::chrono::sys_days;
using weather::Day;

/// Something of a day that [[season_keys]] and season.table may both say.
struct Quantity {
  const char* key;
  std::optional<double> SeasonKey::*of_key;
  std::optional<double> Day::*of_table;  ///< nullptr: every table has it
};

constexpr Quantity quantities[] = {
    {"weathering", &SeasonKey::weathering, nullptr},
    {"temperature", &SeasonKey::temperature_c, nullptr},
    {"precipitation", &SeasonKey::precipitation_mm_day, nullptr},
    {"cloud_cover", &SeasonKey::cloud_cover, &Day::cloud_cover},
    {"wind_speed", &SeasonKey::wind_speed_m_s, &Day::wind_speed_m_s},
    {"wind_heading", &SeasonKey::wind_heading_deg, &Day::wind_heading_deg},
    {"visual_range", &SeasonKey::visual_range_m, &Day::visual_range_m},
};

/// The keys that win over the table: "temperature (on 7 days)".
std::vector<std::string> winning_keys(const scene::Scene& scene, const std::vector<Day>& table) {
  std::vector<std::string> winning;
  for (const Quantity& quantity : quantities) {
    const auto days = std::ranges::count_if(scene.season_keys, [&](const SeasonKey& key) {
      return (key.*quantity.of_key).has_value();
    });
    const bool in_table =
        quantity.of_table == nullptr || std::ranges::any_of(table, [&](const Day& day) {
          return (day.*quantity.of_table).has_value();
        });
    if (days > 0 && in_table)
      winning.push_back(fmt::format("{} (on {} day{})", quantity.key, days, days == 1 ? "" : "s"));
  }
  return winning;
}

void warn_of_a_table_that_does_not_count(const scene::Scene& scene,
                                         std::vector<std::string>& warnings) {
  if (scene.season.table.empty() || scene.season_keys.empty()) return;
  const std::vector<std::string> winning =
      winning_keys(scene, weather::read_daily_weather(scene.season.table, scene.sun.latitude_deg));
  if (winning.empty()) return;
  warnings.push_back(fmt::format(
      "[[season_keys]] win over season.table on every day of the season, also between and beyond "
      "their own days, in what they give: {}; take these keys out for the table's weather",
      fmt::join(winning, ", ")));
}

void warn_of_days_outside(const scene::Scene& scene, std::vector<std::string>& warnings) {
  const sys_days first = scene::date_of(scene.season.first);
  const sys_days last = scene::date_of(scene.season.last);
  std::vector<std::string> outside;
  for (std::size_t item = 0; item < scene.season_keys.size(); ++item) {
    const sys_days date = scene::date_of(scene.season_keys[item].date);
    if (date < first || date > last)
      outside.push_back(fmt::format("season_keys[{}] ({:%Y-%m-%d})", item + 1, date));
  }
  if (outside.empty()) return;
  warnings.push_back(fmt::format(
      "{} of the {} [[season_keys]] lie outside the season, {:%Y-%m-%d} to {:%Y-%m-%d}, and are "
      "not reached: {}; change their dates, or season.first and season.last",
      outside.size(), scene.season_keys.size(), first, last, fmt::join(outside, ", ")));
}

}  // namespace

std::vector<std::string> season_warnings(const scene::Scene& film) {
  std::vector<std::string> warnings;
  if (!scene::is_season(film)) return warnings;
  warn_of_a_table_that_does_not_count(film, warnings);
  warn_of_days_outside(film, warnings);
  return warnings;
}

}  // namespace wold::advice
