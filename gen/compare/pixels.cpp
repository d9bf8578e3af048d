#include "compare/pixels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wold::compare {

double mean(const Image& image) {
  const double sum = std::accumulate(image.values.begin(), image.values.end(), 0.0);
  return sum / static_cast<double>(std::max<std::size_t>(image.values.size(), 1));
}

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
