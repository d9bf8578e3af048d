#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace wold::wind::test {

using Transform = std::vector<std::complex<double>>;

/// sum f(x) exp(-2 pi i k x / n), n a power of two: halves, again and again.
inline Transform transform_of(const Transform& values) {
  const std::size_t n = values.size();
  if (n == 1) return values;
  Transform even, odd;
  for (std::size_t i = 0; i < n; i += 2) {
    even.push_back(values[i]);
    odd.push_back(values[i + 1]);
  }
  even = transform_of(even);
  odd = transform_of(odd);
  Transform result(n);
  for (std::size_t k = 0; k < n / 2; ++k) {
    const double angle = -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    const std::complex<double> turned = std::polar(1.0, angle) * odd[k];
    result[k] = even[k] + turned;
    result[k + n / 2] = even[k] - turned;
  }
  return result;
}

/// The same through Hann's window, whose mean square is 3/8.
inline Transform windowed(Transform values) {
  const auto n = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] *= std::sin(std::numbers::pi * static_cast<double>(i) / n) *
                 std::sin(std::numbers::pi * static_cast<double>(i) / n);
  return transform_of(values);
}

/// Variance of a line of values, by the periodogram through Hann's window, of waves from
/// low_per_m to below high_per_m.
inline double variance_between(const Transform& transform, double step_m, double low_per_m,
                               double high_per_m) {
  const auto n = static_cast<double>(transform.size());
  double sum = 0.0;
  for (std::size_t k = 1; k < transform.size() / 2; ++k) {
    const double per_m = static_cast<double>(k) / (n * step_m);
    if (per_m >= low_per_m && per_m < high_per_m) sum += 2.0 * std::norm(transform[k]);
  }
  return sum / (n * n * 0.375);
}

}  // namespace wold::wind::test
