#pragma once

#include <algorithm>

namespace wold::phenology {

/// 0 below `low`, 1 above `high`, linear between; low < high.
inline double ramp(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

}  // namespace wold::phenology
