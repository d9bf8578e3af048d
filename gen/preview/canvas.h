#pragma once

#include <limits>
#include <vector>

#include "core/image.h"

namespace wold::preview {

/// A picture being painted: radiance, and how deep what is seen lies.
struct Canvas {
  Canvas(int width_px, int height_px)
      : radiance(width_px, height_px, 3),
        depth_m(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px),
                std::numeric_limits<float>::infinity()) {}

  float& depth_at(int x, int y) {
    return depth_m[static_cast<std::size_t>(y) * static_cast<std::size_t>(radiance.width) +
                   static_cast<std::size_t>(x)];
  }

  Image radiance;
  std::vector<float> depth_m;
};

}  // namespace wold::preview
