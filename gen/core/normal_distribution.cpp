#include "core/normal_distribution.h"

#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold {

double normal_cdf(double value) { return 0.5 * math::erfc(-value / std::numbers::sqrt2); }

double normal_quantile(double probability) {
  // Newton's method on the distribution's logarithm-free tail converges from Winitzki's (2008)
  // approximation of the inverse error function in three steps to the last bits.
  const double x = 2.0 * probability - 1.0;
  const double log_term = math::log(4.0 * probability * (1.0 - probability));
  constexpr double a = 0.147;
  const double half = 2.0 / (std::numbers::pi * a) + 0.5 * log_term;
  double value = std::copysign(std::sqrt(std::sqrt(half * half - log_term / a) - half), x) *
                 std::numbers::sqrt2;
  for (int step = 0; step < 3; ++step) {
    const double density = math::exp(-0.5 * value * value) / std::sqrt(2.0 * std::numbers::pi);
    value -= (normal_cdf(value) - probability) / density;
  }
  return value;
}

}  // namespace wold
