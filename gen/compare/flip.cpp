#include "compare/flip.h"

#include <cmath>

#include "compare/flip_colours.h"
#include "compare/flip_features.h"
#include "compare/pixels.h"
#include "core/elementary.h"

namespace wold::compare {
namespace {

/// Section 4.3: differing edges and points amplify differing colours.
void combine(float* out, const float* colours, const float* features) {
  out[0] = math::pow(colours[0], 1.0F - features[0]);
}

}  // namespace

Image flip_map(const Image& got, const Image& want, double pixels_per_degree) {
  const Image got_opponent = opponent_colours(got);
  const Image want_opponent = opponent_colours(want);
  return pixelwise(1, combine, colour_differences(got_opponent, want_opponent, pixels_per_degree),
                   feature_differences(got_opponent, want_opponent, pixels_per_degree));
}

}  // namespace wold::compare
