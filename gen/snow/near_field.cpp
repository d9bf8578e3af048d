#include "snow/near_field.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "snow/raindrops.h"

namespace wold::snow {
namespace {

/// What can be drawn of what falls: flakes per m3 and their extinction, and that of all.
struct Drawable {
  double number_per_m3;
  double extinction_per_m;
  double all_per_m;
};

NearField shared(const Drawable& drawable, double solid_angle_sr, double flakes) {
  constexpr double max_optical_depth = 0.05, depth_of_visibility = 3.912;
  const double reach_m =
      std::min(math::cbrt(flakes / (2.0 * drawable.number_per_m3 * solid_angle_sr)),
               max_optical_depth / drawable.extinction_per_m);
  const double drawn_depth = drawable.extinction_per_m * reach_m;
  return {drawable.number_per_m3, reach_m,
          drawable.all_per_m * (1.0 - drawn_depth / depth_of_visibility)};
}

}  // namespace

NearField near_field(double rate_mm_h, double solid_angle_sr, double flakes) {
  const SizeDistribution sizes = gunn_marshall(rate_mm_h);
  return shared({sizes.number_above_per_m3(min_melted_mm),
                 sizes.extinction_above_per_m(seen_efficiency, min_melted_mm),
                 sizes.extinction_per_m(seen_efficiency)},
                solid_angle_sr, flakes);
}

NearField near_rain(double rate_mm_h, double heaviest_mm_h, double solid_angle_sr, double drops) {
  const SizeDistribution sizes = marshall_palmer(rate_mm_h);
  NearField field = shared({sizes.number_above_per_m3(min_drop_mm),
                            rain_extinction_above_per_m(sizes, seen_efficiency, min_drop_mm),
                            rain_extinction_above_per_m(sizes, seen_efficiency, 0.0)},
                           solid_angle_sr, drops);
  field.number_per_m3 = marshall_palmer(heaviest_mm_h).number_above_per_m3(min_drop_mm);
  return field;
}

}  // namespace wold::snow
