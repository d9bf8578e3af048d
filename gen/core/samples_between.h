#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold {

/// From the first sample of a grid's axis in [low_m, high_m] to the last; the first is beyond the
/// last where none is. `corner_m`: where on the axis the grid begins.
inline glm::ivec2 samples_between(double low_m, double high_m, double corner_m,
                                  const GroundGrid& grid) {
  const double last = grid.samples - 1.0;
  return {
      static_cast<int>(std::clamp(std::ceil((low_m - corner_m) / grid.step_m()), 0.0, last + 1)),
      static_cast<int>(std::clamp(std::floor((high_m - corner_m) / grid.step_m()), -1.0, last))};
}

}  // namespace wold
