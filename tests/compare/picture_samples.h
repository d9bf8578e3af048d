#pragma once

#include <algorithm>
#include <cmath>

#include "core/image.h"

namespace wold::test {

inline Image flat(int width, int height, const std::vector<float>& pixel) {
  Image image(width, height, static_cast<int>(pixel.size()));
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = pixel[i % pixel.size()];
  return image;
}

/// Waves of colour, 64 x 48 pixels, their contrast and place given.
inline Image waves(double contrast, double shift) {
  Image image(64, 48, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] =
            static_cast<float>(0.5 + 0.5 * contrast * std::sin(0.2 * x + 0.1 * y * c + c + shift));
  return image;
}

/// Fainter waves a little to the side, with a white square of 3 x 3 pixels.
inline Image other_waves() {
  Image image = waves(0.9, 0.3);
  for (int y = 20; y < 23; ++y)
    for (int x = 20; x < 23; ++x) std::fill_n(image.pixel(x, y), 3, 1.0F);
  return image;
}

}  // namespace wold::test
