#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace wold::cloud {

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
    return at(remainder_of(x, width_), remainder_of(y, height_));
  }

  /// Bilinear; (s, t) in periods, any numbers below 2^31 periods.
  double sample(double s, double t) const {
    const double x = (s - std::floor(s)) * width_ - 0.5;
    const double y = (t - std::floor(t)) * height_ - 0.5;
    const auto i = static_cast<long>(std::floor(x));
    const auto j = static_cast<long>(std::floor(y));
    const double u = x - static_cast<double>(i);
    const double v = y - static_cast<double>(j);
    return (1.0 - v) * ((1.0 - u) * wrapped(i, j) + u * wrapped(i + 1, j)) +
           v * ((1.0 - u) * wrapped(i, j + 1) + u * wrapped(i + 1, j + 1));
  }

 private:
  std::size_t offset(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  }
  static int remainder_of(long i, int period) {
    const long rest = i % period;
    return static_cast<int>(rest < 0 ? rest + period : rest);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

}  // namespace wold::cloud
