#include "sky/cloud_haze.h"

#include <cmath>

#include "core/elementary.h"
#include "light/daylight.h"

namespace wold::sky {

double clear_fraction(double distance_m, double rise_m, double visual_range_m) {
  constexpr double haze_height_m = 1200.0;
  const double relative = rise_m / haze_height_m;
  const double in_haze_m = distance_m * -math::expm1(-relative) / relative;
  return 1.0 - light::haze_fraction(in_haze_m, visual_range_m);
}

}  // namespace wold::sky
