#pragma once

#include "core/image.h"
#include "core/parallel.h"

namespace wold::compare {

/// A picture made pixel by pixel from others of one size: rule(out, in...) is given where the
/// channels of the pixel start in each.
template <class Rule, class... Images>
Image pixelwise(int channels, const Rule& rule, const Image& first, const Images&... others) {
  Image result(first.width, first.height, channels);
  parallel_for(static_cast<std::size_t>(first.height), [&](std::size_t row) {
    const auto y = static_cast<int>(row);
    for (int x = 0; x < first.width; ++x)
      rule(result.pixel(x, y), first.pixel(x, y), others.pixel(x, y)...);
  });
  return result;
}

/// Of all values of all channels; 0 for an empty picture.
double mean(const Image& image);

/// Red, green and blue as a screen shows them: values held in [0, 1], those that are no numbers 0,
/// alpha left out, and greys for pictures of one or two channels.
Image shown_rgb(const Image& image);

}  // namespace wold::compare
