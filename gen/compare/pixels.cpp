#include "compare/pixels.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"

namespace wold::compare {

double mean(const Image& image) { return wold::mean(image.values); }

Image shown_rgb(const Image& image) {
  const bool is_grey = image.channels < 3;
  return pixelwise(
      3,
      [&](float* shown, const float* pixel) {
        for (int c = 0; c < 3; ++c) {
          const float value = pixel[is_grey ? 0 : c];
          shown[c] = std::isnan(value) ? 0.0F : std::clamp(value, 0.0F, 1.0F);
        }
      },
      image);
}

}  // namespace wold::compare
