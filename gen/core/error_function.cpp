#include <array>
#include <cmath>
#include <numbers>

#include "core/double_double.h"
#include "core/elementary.h"
#include "core/exponential.h"

namespace wold::math {
namespace {

/// erf(x) for |x| < 1, by its series of positive terms (Abramowitz and Stegun 7.1.6).
double erf_series(double x) {
  double sum = 0.0;
  for (int n = 24; n > 0; --n) sum = (1.0 + sum) * (2.0 * x * x / (2.0 * n + 1.0));
  return 2.0 * std::numbers::inv_sqrtpi * exp(-x * x) * (x + x * sum);
}

/// exp(-x^2), with x^2 exact.
double gaussian(double x) {
  const DoubleDouble square = exact_product(x, x);
  return rounded(scaled_exp(-square));
}

/// erfc(x) for x > 0.5 by the trapezoidal rule with the step h, and what its pole leaves: Matta and
/// Reichel, "Uniform computation of the error function and other related functions" (1971). Its
/// error is exp(-(pi / h)^2).
double erfc_by_trapezia(double x) {
  constexpr double h = 0.5;
  constexpr int terms = 13;
  static const auto weights = [] {
    std::array<double, terms> all{};
    for (int n = 0; n < terms; ++n) all[static_cast<std::size_t>(n)] = gaussian(n * h);
    return all;
  }();
  double sum = 0.0;
  for (int n = terms - 1; n > 0; --n)
    sum += 2.0 * weights[static_cast<std::size_t>(n)] / (n * h * n * h + x * x);
  sum += 1.0 / (x * x);
  const double rule = h * x * std::numbers::inv_pi * gaussian(x) * sum;
  constexpr double period = 2.0 * std::numbers::pi / h;
  return x < std::numbers::pi / h ? rule - 2.0 / expm1(period * x) : rule;
}

}  // namespace

double erfc(double x) {
  if (std::isnan(x)) return x;
  if (std::abs(x) <= 0.5) return 1.0 - erf_series(x);
  if (x < -7.0) return 2.0;
  if (x < 0.0) return 2.0 - erfc_by_trapezia(-x);
  return x < 28.0 ? erfc_by_trapezia(x) : 0.0;
}

}  // namespace wold::math
