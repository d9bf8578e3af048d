#include "report/season_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace wold::report {
namespace {

using phenology::SeasonDay;
using Value = double SeasonDay::*;

// Can be told apart by the colour-blind (Okabe and Ito 2008, Color Universal Design).
constexpr const char* green = "#009e73";
constexpr const char* vermilion = "#d55e00";
constexpr const char* blue = "#0072b2";
constexpr double line_px = 1.6;

std::string iso_date(std::chrono::sys_days day) {
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

/// Time as a number of which charts have round ticks: days when there are few, or else years.
struct TimeScale {
  std::chrono::sys_days first;
  std::chrono::sys_days last;

  static constexpr double days_per_year = 365.2425;
  bool in_years() const { return (last - first).count() > 800; }

  double at(std::chrono::sys_days day) const {
    if (!in_years()) return static_cast<double>((day - first).count());
    return 1970.0 + static_cast<double>(day.time_since_epoch().count()) / days_per_year;
  }

  chart::Axis axis() const {
    const double end = std::max(at(last), at(first) + 1.0);
    return in_years() ? chart::linear_axis("year", at(first), end)
                      : chart::linear_axis(fmt::format("days since {}", iso_date(first)), 0.0, end);
  }
};

chart::Line line_of(std::span<const SeasonDay> days, const TimeScale& time, Value value,
                    const char* label, const char* colour) {
  chart::Line line{label, {}, {.colour = colour, .width_px = line_px}};
  for (const SeasonDay& day : days) line.points.emplace_back(time.at(day.date), day.*value);
  return line;
}

chart::Panel snow_panel(std::span<const SeasonDay> days, const TimeScale& time, Value value,
                        const char* title, const char* axis, double min_range) {
  double max = min_range;
  for (const SeasonDay& day : days) max = std::max(max, day.*value);
  return {title,
          time.axis(),
          chart::linear_axis(axis, 0.0, max),
          {line_of(days, time, value, "", blue)}};
}

}  // namespace

std::vector<Column> season_table(std::span<const SeasonDay> days) {
  std::vector<Column> table = {{"date", {}, {}}};
  for (const SeasonDay& day : days) table[0].words.push_back(iso_date(day.date));
  const auto add = [&](const char* name, Value value) {
    Column column{name, {}};
    for (const SeasonDay& day : days) column.values.push_back(day.*value);
    table.push_back(std::move(column));
  };
  add("greenness", &SeasonDay::greenness);
  add("weathering_degree", &SeasonDay::weathering_degree);
  add("snow_depth_m", &SeasonDay::snow_depth_m);
  add("swe_mm", &SeasonDay::snow_water_mm);
  return table;
}

chart::Figure season_figure(const std::string& scene_name, std::span<const SeasonDay> days) {
  const TimeScale time{days.front().date, days.back().date};
  const chart::Panel meadow = {
      "Meadow",
      time.axis(),
      chart::linear_axis("share", 0.0, 1.0),
      {line_of(days, time, &SeasonDay::weathering_degree, "weathering degree", vermilion),
       line_of(days, time, &SeasonDay::greenness, "greenness", green)}};
  return {
      fmt::format("Season of the scene {}", scene_name),
      fmt::format("What the weather makes of level, open ground from {} to {}.",
                  iso_date(days.front().date), iso_date(days.back().date)),
      {meadow, snow_panel(days, time, &SeasonDay::snow_depth_m, "Depth of snow", "depth (m)", 0.1),
       snow_panel(days, time, &SeasonDay::snow_water_mm, "Water of the snow", "water (mm)", 10.0)},
      1,
      {900.0, 170.0}};
}

}  // namespace wold::report
