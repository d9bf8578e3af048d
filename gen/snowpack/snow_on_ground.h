#pragma once

#include <span>
#include <vector>

#include "snowpack/snow_layer.h"
#include "weather/daily_weather.h"

namespace wold::snowpack {

/// Snow on level, open ground.
struct SnowOnGround {
  double depth_m = 0.0;
  double water_mm = 0.0;  ///< ice and liquid, kg/m2
};

/// The snow of each day as observers find it: at six in the morning, before what falls on that day.
/// In the first there is lain_snow() of `first_mm`. A SnowLayer in the days' DailyForcing, in steps
/// of three hours.
std::vector<SnowOnGround> snow_on_ground(std::span<const weather::Day> days,
                                         const SnowParameters& snow = {}, double first_mm = 0.0);

}  // namespace wold::snowpack
