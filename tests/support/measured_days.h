#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "snowpack/snow_on_ground.h"
#include "support/places.h"
#include "weather/daily_weather.h"
#include "weather/number_table.h"

namespace wold::test {

/// Daily weather with something that was measured on some of the days.
struct MeasuredDays {
  std::string place;
  std::vector<weather::Day> days;
  std::vector<double> measured;  ///< of each day, NaN where there is none
};

inline std::filesystem::path measured_file(const std::string& place) {
  return tests_folder() / "data" / "weather" / (place + ".csv");
}

inline MeasuredDays measured_days(const std::string& place, const std::string& column,
                                  double latitude_deg) {
  MeasuredDays result{place, weather::read_daily_weather(measured_file(place), latitude_deg), {}};
  const auto table =
      weather::read_table(measured_file(place),
                          {{.name = "date", .rises = true, .required = true, .is_date = true},
                           {.name = column, .unit = "", .required = true, .may_be_empty = true}},
                          weather::OtherColumns::ignored);
  result.measured.assign(result.days.size(), std::nan(""));
  for (std::size_t row = 0; row < table.lines.size(); ++row)
    result.measured[static_cast<std::size_t>(table.columns[0][row] - table.columns[0][0])] =
        table.columns[1][row];
  return result;
}

inline const std::vector<std::string>& grasslands() {
  static const std::vector<std::string> places = {"phenocam_freemangrass_grass",
                                                  "phenocam_lethbridge_grassland",
                                                  "phenocam_marena_canopy", "phenocam_vaira_grass"};
  return places;
}

/// Calendar year of a day, or with `winter` that in which its winter began.
inline int year_of(const weather::Day& day, bool winter = false) {
  const std::chrono::year_month_day date(day.date);
  return static_cast<int>(date.year()) -
         (winter && static_cast<unsigned>(date.month()) < 8 ? 1 : 0);
}

/// Of November to April, when there may be snow.
inline bool in_winter(const weather::Day& day) {
  const unsigned month(std::chrono::year_month_day(day.date).month());
  return month >= 11 || month <= 4;
}

/// `number` of the modelled snow of each day.
inline std::vector<double> modelled_snow(const std::vector<weather::Day>& days,
                                         double snowpack::SnowOnGround::*number,
                                         const snowpack::SnowParameters& snow = {}) {
  std::vector<double> numbers;
  for (const snowpack::SnowOnGround& morning : snowpack::snow_on_ground(days, snow))
    numbers.push_back(morning.*number);
  return numbers;
}

/// The last day of the winter that began in `year` on which 5 cm of snow or more lie.
inline std::optional<std::chrono::sys_days> last_snow(const std::vector<weather::Day>& days,
                                                      const std::vector<double>& depths_m,
                                                      int year) {
  std::optional<std::chrono::sys_days> last;
  for (std::size_t i = 0; i < days.size(); ++i)
    if (year_of(days[i], true) == year && depths_m[i] >= 0.05) last = days[i].date;
  return last;
}

/// Sum over the chosen days of the squared error, and of the measured values' about their mean.
struct Fit {
  double squared_error = 0.0;
  double variance = 0.0;
  int count = 0;

  double rmse() const { return std::sqrt(squared_error / count); }
  /// Nash and Sutcliffe 1970: 1 is perfect, 0 no better than the mean.
  double efficiency() const { return 1.0 - squared_error / variance; }
};

template <typename Chosen>
Fit fit_of(const MeasuredDays& place, const std::vector<double>& modelled, const Chosen& chosen) {
  Fit fit;
  double sum = 0.0;
  const auto each = [&](const auto& action) {
    for (std::size_t i = 0; i < modelled.size(); ++i)
      if (!std::isnan(place.measured[i]) && chosen(place.days[i])) action(i);
  };
  each([&](std::size_t i) { sum += place.measured[i], ++fit.count; });
  each([&](std::size_t i) {
    const double error = modelled[i] - place.measured[i];
    const double departure = place.measured[i] - sum / fit.count;
    fit.squared_error += error * error;
    fit.variance += departure * departure;
  });
  return fit;
}

}  // namespace wold::test
