#include "weather/daily_weather.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/elementary.h"
#include "core/error.h"
#include "scene/registry.h"
#include "weather/day_length.h"
#include "weather/number_table.h"

namespace wold::weather {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_gap_days = 366.0;
constexpr int same_season_days = 15;
constexpr double seconds_per_hour = 3600.0, hours_per_day = 24.0;

/// The columns by their places in the table.
enum ColumnIndex {
  date,
  tmin,
  tmax,
  precipitation,
  day_length,
  wind_speed,
  wind_heading,
  clouds,
  visual_range,
  column_count
};

TableColumn weather_column(const char* name, double lowest, double highest, const char* unit,
                           bool required = false) {
  return {.name = name,
          .lowest = lowest,
          .highest = highest,
          .unit = unit,
          .required = required,
          .may_be_empty = true};
}

TableColumn column_like(const char* name, const char* key_name) {
  const scene::Key& key = *scene::find_key(key_name);
  return weather_column(name, key.lowest, key.highest, key.unit.c_str());
}

/// Ranges hold what has been measured on Earth: -89.2 and 56.7 degrees, 1825 mm in a day.
std::vector<TableColumn> columns() {
  return {{.name = "date", .rises = true, .required = true, .is_date = true},
          weather_column("tmin_c", -90.0, 60.0, "deg C", true),
          weather_column("tmax_c", -90.0, 60.0, "deg C", true),
          weather_column("precipitation_mm", 0.0, 2000.0, "mm", true),
          weather_column("day_length_s", 0.0, 24.0 * seconds_per_hour, "s"),
          column_like("wind_speed_m_s", "wind.speed"),
          column_like("wind_heading_deg", "wind.heading"),
          weather_column("cloud_cover", 0.0, 1.0, ""),
          column_like("visual_range_m", "sky.visual_range")};
}

bool is_number(double value) { return !std::isnan(value); }

/// What rows must be to one another, cell by cell.
void check_rows(const std::string& file, const NumberTable& table) {
  std::vector<Problem> problems;
  const auto note = [&](int line, ColumnIndex wrong, std::string message) {
    problems.push_back({{file, line, table.places[wrong]}, std::move(message)});
  };
  const auto& column = table.columns;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    if (column[tmin][i] > column[tmax][i])
      note(table.lines[i], tmin,
           fmt::format("found tmin_c {:g} above tmax_c {:g}, expected at most that",
                       column[tmin][i], column[tmax][i]));
    if (i > 0 && column[date][i] - column[date][i - 1] > longest_gap_days)
      note(table.lines[i], date,
           "found a day more than a year after the one above, expected days in a row");
  }
  for (const ColumnIndex needed : {tmin, tmax, precipitation})
    if (std::none_of(column[needed].begin(), column[needed].end(), is_number))
      note(table.lines[0], needed,
           fmt::format("found no number in the column {}, expected some", columns()[needed].name));
  if (!problems.empty()) throw InputError(std::move(problems));
}

/// One column as a value a day, NaN where there is none.
std::vector<double> by_day(const NumberTable& table, ColumnIndex wanted) {
  const std::vector<double>& dates = table.columns[date];
  std::vector<double> values(static_cast<std::size_t>(dates.back() - dates.front()) + 1, missing);
  if (!table.columns[wanted].empty())
    for (std::size_t i = 0; i < dates.size(); ++i)
      values[static_cast<std::size_t>(dates[i] - dates.front())] = table.columns[wanted][i];
  return values;
}

/// Gaps as straight lines between the numbers beside them; at the ends the nearest number.
void interpolate_gaps(std::vector<double>& values) {
  auto before = std::ranges::find_if(values, is_number);
  if (before == values.end()) return;
  std::fill(values.begin(), before, *before);
  for (auto now = before + 1; now != values.end(); ++now) {
    if (!is_number(*now)) continue;
    for (auto gap = before + 1; gap != now; ++gap)
      *gap = std::lerp(*before, *now,
                       static_cast<double>(gap - before) / static_cast<double>(now - before));
    before = now;
  }
  std::fill(before, values.end(), *before);
}

struct Mean {
  double sum = 0.0;
  int count = 0;
  void add(double value) { sum += value, ++count; }
};

/// Mean of what the file has around each day of the year.
std::vector<double> seasonal_means(const std::vector<double>& values, std::chrono::sys_days first) {
  constexpr int days = 366;
  std::vector<Mean> of_day(days);
  Mean of_all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!is_number(values[i])) continue;
    const int day = day_of_year(first + std::chrono::days(i)) - 1;
    for (int shift = -same_season_days; shift <= same_season_days; ++shift)
      of_day[static_cast<std::size_t>((day + shift + days) % days)].add(values[i]);
    of_all.add(values[i]);
  }
  std::vector<double> means;
  for (const Mean& mean : of_day) {
    const Mean& known = mean.count > 0 ? mean : of_all;
    means.push_back(known.sum / known.count);
  }
  return means;
}

void fill_with_seasonal_means(std::vector<double>& values, std::chrono::sys_days first) {
  const std::vector<double> means = seasonal_means(values, first);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_number(values[i]))
      values[i] = means[static_cast<std::size_t>(day_of_year(first + std::chrono::days(i)) - 1)];
}

std::optional<double> if_known(double value) {
  return is_number(value) ? std::optional(value) : std::nullopt;
}

double day_length_error(std::span<const Day> days, double latitude) {
  double sum = 0.0;
  for (const Day& day : days) {
    const double error = day_length_h(day_of_year(day.date), latitude) - day.day_length_h;
    sum += error * error;
  }
  return sum;
}

/// Sets the sun's course by the latitude that the days' lengths tell, if there are any.
void set_sun(std::vector<Day>& days, const std::vector<double>& lengths_s, double latitude) {
  std::vector<Day> known;
  for (std::size_t i = 0; i < days.size(); ++i)
    if (is_number(lengths_s[i])) {
      known.push_back(days[i]);
      known.back().day_length_h = lengths_s[i] / seconds_per_hour;
    }
  if (!known.empty()) latitude = latitude_deg(known);
  for (Day& day : days) {
    day.day_length_h = day_length_h(day_of_year(day.date), latitude);
    day.top_sun_mj_m2 = extraterrestrial_mj_m2(day_of_year(day.date), latitude);
  }
}

}  // namespace

int day_of_year(std::chrono::sys_days day) {
  const std::chrono::year year = std::chrono::year_month_day(day).year();
  return static_cast<int>((day - std::chrono::sys_days(year / 1 / 1)).count()) + 1;
}

std::vector<Day> read_daily_weather(const std::filesystem::path& file, double latitude) {
  const NumberTable table = read_table(file, columns(), OtherColumns::ignored);
  check_rows(file.string(), table);
  const std::chrono::sys_days first{std::chrono::days(static_cast<int>(table.columns[date][0]))};
  std::array<std::vector<double>, column_count> values;
  for (const ColumnIndex column :
       {tmin, tmax, precipitation, day_length, wind_speed, wind_heading, clouds, visual_range})
    values[column] = by_day(table, column);
  interpolate_gaps(values[tmin]);
  interpolate_gaps(values[tmax]);
  fill_with_seasonal_means(values[precipitation], first);
  std::vector<Day> days(values[tmin].size());
  for (std::size_t i = 0; i < days.size(); ++i)
    days[i] = {.date = first + std::chrono::days(i),
               .tmin_c = values[tmin][i],
               .tmax_c = std::max(values[tmin][i], values[tmax][i]),
               .precipitation_mm = values[precipitation][i],
               .wet_h = wet_hours(values[precipitation][i]),
               .wind_speed_m_s = if_known(values[wind_speed][i]),
               .wind_heading_deg = if_known(values[wind_heading][i]),
               .cloud_cover = if_known(values[clouds][i]),
               .visual_range_m = if_known(values[visual_range][i])};
  set_sun(days, values[day_length], latitude);
  return days;
}

double wet_hours(double precipitation_mm) {
  if (!(precipitation_mm > 0.0)) return hours_per_day;
  return std::min(hours_per_day, math::pow(precipitation_mm, 1.0 - 0.612) / 0.425);
}

double latitude_deg(std::span<const Day> days) {
  double best = 0.0;
  for (int latitude = -90; latitude <= 90; ++latitude)
    if (day_length_error(days, latitude) < day_length_error(days, best)) best = latitude;
  double low = std::max(best - 1.0, -90.0), high = std::min(best + 1.0, 90.0);
  while (high - low > 1e-6) {
    const double third = (high - low) / 3.0;
    if (day_length_error(days, low + third) < day_length_error(days, high - third))
      high -= third;
    else
      low += third;
  }
  return 0.5 * (low + high);
}

}  // namespace wold::weather
