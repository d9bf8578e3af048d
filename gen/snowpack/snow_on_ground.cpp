#include "snowpack/snow_on_ground.h"

#include <algorithm>
#include <cstddef>

#include "snowpack/snow_forcing.h"

namespace wold::snowpack {
namespace {

void advance_day(SnowLayer& layer, const DailyForcing& air, const SnowParameters& snow) {
  constexpr int day_h = 24;
  for (int hour = snow_day_h; hour < snow_day_h + day_h; hour += snow_step_h) {
    const double middle = hour + 0.5 * snow_step_h;
    layer.advance(snow_forcing(air.temperature_c(middle), air.precipitation_mm_h() * snow_step_h,
                               air.sky(middle), 0.0, snow),
                  snow_step_h);
  }
}

}  // namespace

std::vector<SnowOnGround> snow_on_ground(std::span<const weather::Day> days,
                                         const SnowParameters& snow, double first_mm) {
  constexpr double level_latitude_deg = 0.0;  // the level does not ask from where the sun shines
  std::vector<SnowOnGround> mornings;
  SnowLayer layer(snow, lain_snow(first_mm));
  for (std::size_t i = 0; i < days.size(); ++i) {
    mornings.push_back({layer.depth_m(), layer.water_mm()});
    const weather::Day& next = days[std::min(i + 1, days.size() - 1)];
    advance_day(layer, DailyForcing(days[i], next, level_latitude_deg), snow);
  }
  return mornings;
}

}  // namespace wold::snowpack
