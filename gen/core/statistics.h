#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

namespace wold {

/// The arithmetic mean of numbers, summed up in their order; 0 of none.
inline double mean(std::span<const float> values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return sum / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

/// Makes the mean of the values 0.
inline void subtract_mean(std::span<float> values) {
  const auto average = static_cast<float>(mean(values));
  for (float& value : values) value -= average;
}

}  // namespace wold
