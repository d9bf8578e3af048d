#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "weather/daily_weather.h"

namespace wold::phenology {

/// What a season's weather has made of level, open ground by one day.
struct SeasonDay {
  std::chrono::sys_days date;
  double greenness = 0.0;          ///< see greenness()
  double weathering_degree = 0.0;  ///< see weathering_degrees()
  double snow_depth_m = 0.0;       ///< in the morning, see snow_on_ground()
  double snow_water_mm = 0.0;
};

/// One for each of the days, which are in a row; in the first, fresh snow of so much water lies.
std::vector<SeasonDay> season_of(std::span<const weather::Day> days, double first_snow_mm = 0.0);

}  // namespace wold::phenology
