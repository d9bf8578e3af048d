#pragma once

#include <cmath>

#include "core/image.h"

namespace wold::test {

constexpr int blur_box = 8;  ///< pixels

/// Mean of the box of pixels from a pixel on, of a channel.
inline double blurred(const Image& picture, int x, int y, int channel) {
  double sum = 0.0;
  for (int j = 0; j < blur_box; ++j)
    for (int i = 0; i < blur_box; ++i) sum += double{picture.pixel(x + i, y + j)[channel]};
  return sum / (blur_box * blur_box);
}

/// Mean absolute difference of two pictures in [0, 1] after a box blur.
inline double blurred_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y + blur_box <= a.height; ++y)
    for (int x = 0; x + blur_box <= a.width; ++x)
      for (int c = 0; c < 3; ++c, ++count)
        sum += std::abs(blurred(a, x, y, c) - blurred(b, x, y, c));
  return sum / count;
}

}  // namespace wold::test
