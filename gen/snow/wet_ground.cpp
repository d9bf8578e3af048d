#include "snow/wet_ground.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::snow {

double ground_wetness(const Weather& weather, double time_s, double height_m) {
  constexpr double dries_s = 3.0 * 3600.0, remembers_s = 24.0 * 3600.0, step_s = 300.0;
  constexpr double soaked_mm = 0.5, seconds_per_hour = 3600.0;
  const double since_s = std::max(time_s - remembers_s, -weather.earlier_s());
  if (time_s <= since_s) return 0.0;
  const int steps = static_cast<int>(std::ceil((time_s - since_s) / step_s));
  const double length_s = (time_s - since_s) / steps;
  const double kept = math::exp(-length_s / dries_s);
  double water_mm = 0.0;
  for (int step = 0; step < steps; ++step) {
    const double rain_mm_h = weather.falling_rain_mm_h(since_s + (step + 0.5) * length_s, height_m);
    water_mm = water_mm * kept + rain_mm_h * dries_s / seconds_per_hour * (1.0 - kept);
  }
  return -math::expm1(-water_mm / soaked_mm);
}

double wet_albedo(double dry) {
  // Of diffuse light a film of water throws back 6.6 % from outside, and so from inside, where
  // all directions that are too slanted are thrown back, 1 - (1 - 0.066) / n^2.
  constexpr double index = 1.33, mirrored = 0.02, from_outside = 0.066;
  constexpr double from_inside = 1.0 - (1.0 - from_outside) / (index * index);
  return (1.0 - mirrored) * (1.0 - from_inside) * dry / (1.0 - from_inside * dry);
}

}  // namespace wold::snow
