#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "grass/optics/leaf_optics.h"

namespace wold::grass {
namespace {

/// Abramowitz and Stegun 5.1.11, for 0 < x <= 1.
double by_series(double x) {
  double sum = 0.0;
  double power = 1.0;  // (-x)^n / n!
  for (int n = 1; n <= 20; ++n) {
    power *= -x / n;
    sum += power / n;
  }
  return -std::numbers::egamma - math::log(x) - sum;
}

/// Abramowitz and Stegun 5.1.22, even part, from its end, for x > 1.
double by_continued_fraction(double x) {
  const int terms = 8 + static_cast<int>(100.0 / x);
  double rest = 0.0;
  for (int n = terms; n > 0; --n) rest = 1.0 * n * n / (x + 2.0 * n + 1.0 - rest);
  return math::exp(-x) / (x + 1.0 - rest);
}

}  // namespace

double exponential_integral(double x) {
  if (!(x > 0.0))
    return x == 0.0 ? std::numeric_limits<double>::infinity()
                    : std::numeric_limits<double>::quiet_NaN();
  return x <= 1.0 ? by_series(x) : by_continued_fraction(x);
}

}  // namespace wold::grass
