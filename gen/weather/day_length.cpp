#include "weather/day_length.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"

namespace wold::weather {
namespace {

using std::numbers::pi;

/// Half the day as the angle that the Earth turns by, 0 to pi.
double sunset_rad(double latitude_rad, double declination) {
  return math::acos(std::clamp(-math::tan(latitude_rad) * math::tan(declination), -1.0, 1.0));
}

}  // namespace

double declination_rad(int day_of_year) {
  return -0.4092797 * math::cos((day_of_year + 10.25) * 0.017214);
}

double day_length_h(int day_of_year, double latitude_deg) {
  return 24.0 / pi * sunset_rad(radians(latitude_deg), declination_rad(day_of_year));
}

double extraterrestrial_mj_m2(int day_of_year, double latitude_deg) {
  constexpr double solar_mj_m2_min = 0.0820;
  constexpr double minutes_per_day = 24.0 * 60.0;
  const double latitude = radians(latitude_deg);
  const double declination = declination_rad(day_of_year);
  const double nearness = 1.0 + 0.033 * math::cos(2.0 * pi / 365.0 * day_of_year);
  const double sunset = sunset_rad(latitude, declination);
  return minutes_per_day / pi * solar_mj_m2_min * nearness *
         (sunset * math::sin(latitude) * math::sin(declination) +
          math::cos(latitude) * math::cos(declination) * math::sin(sunset));
}

}  // namespace wold::weather
