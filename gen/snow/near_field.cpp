#include "snow/near_field.h"

#include <algorithm>
#include <cmath>

#include "snow/size_distribution.h"

namespace wold::snow {

NearField near_field(double rate_mm_h, double solid_angle_sr, double flakes) {
  constexpr double most_optical_depth = 0.05, depth_of_visibility = 3.912;
  const SizeDistribution sizes = gunn_marshall(rate_mm_h);
  const double number = sizes.number_above_per_m3(least_melted_mm);
  const double drawable = sizes.extinction_above_per_m(seen_efficiency, least_melted_mm);
  const double reach_m =
      std::min(std::cbrt(flakes / (2.0 * number * solid_angle_sr)), most_optical_depth / drawable);
  const double drawn_depth = drawable * reach_m;
  return {number, reach_m,
          sizes.extinction_per_m(seen_efficiency) * (1.0 - drawn_depth / depth_of_visibility)};
}

}  // namespace wold::snow
