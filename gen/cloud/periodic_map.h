#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/interpolation.h"

namespace wold::cloud {

/// Where an index falls in a row of `period` > 0 places that repeats: in [0, period).
inline int wrapped_index(long i, int period) {
  const long rest = i % period;
  return static_cast<int>(rest < 0 ? rest + period : rest);
}

/// A picture that continues at its other side: width x height values on cell centres, rows from
/// the south, x east. Any whole indices are good.
template <class T>
class PeriodicMap {
 public:
  PeriodicMap() = default;
  PeriodicMap(int width, int height, T value = {})
      : width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {
    if (width < 1 || height < 1)
      throw std::invalid_argument("a periodic map needs at least 1 x 1 values, got " +
                                  std::to_string(width) + " x " + std::to_string(height));
  }

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<T>& values() const { return values_; }
  std::vector<T>& values() { return values_; }
  T* row(int y) { return values_.data() + offset(y); }
  const T* row(int y) const { return values_.data() + offset(y); }

  /// Indices inside the map.
  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }

  /// Any indices.
  const T& wrapped(long x, long y) const {
    return at(wrapped_index(x, width_), wrapped_index(y, height_));
  }

  /// Bilinear; (s, t) in periods, any numbers below 2^31 periods.
  double sample(double s, double t) const {
    const double x = (s - std::floor(s)) * width_ - 0.5;
    const double y = (t - std::floor(t)) * height_ - 0.5;
    const int i = static_cast<int>(x + 1.0) - 1;  // rounds down: x is -0.5 at least
    const int j = static_cast<int>(y + 1.0) - 1;
    const double u = x - i;
    const double v = y - j;
    const T* low = row(j < 0 ? height_ - 1 : j);
    const T* high = row(j + 1 == height_ ? 0 : j + 1);
    const int left = i < 0 ? width_ - 1 : i;
    const int right = i + 1 == width_ ? 0 : i + 1;
    return bilinear<double>(low[left], low[right], high[left], high[right], u, v);
  }

 private:
  std::size_t offset(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

}  // namespace wold::cloud
