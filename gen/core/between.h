#pragma once

#include <algorithm>
#include <cstddef>

namespace wold {

/// Between which two of `count` values, which lie evenly over [0, 1], a value is, and how far on
/// the way from the first to the second. Beyond [0, 1] it counts as its end. `count` is 2 or more.
struct Between {
  std::size_t first;
  float part;

  Between(double fraction, std::size_t count) {
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count - 1);
    first = std::min(static_cast<std::size_t>(place), count - 2);
    part = static_cast<float>(place - static_cast<double>(first));
  }
};

}  // namespace wold
