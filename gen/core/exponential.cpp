#include "core/exponential.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/elementary.h"

namespace wold::math {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// exp(x) = 2^exponent 2^(step / steps) exp(rest), |rest| < ln 2 / 256: Tang, "Table-driven
// implementation of the exponential function in IEEE floating-point arithmetic" (1989).
constexpr int steps = 128;

constexpr DoubleDouble exp_series(DoubleDouble x) {
  DoubleDouble sum{1.0, 0.0};
  for (int n = 14; n > 0; --n) sum = DoubleDouble{1.0, 0.0} + sum * x / DoubleDouble{1.0 * n, 0.0};
  return sum;
}

/// 2^(i / steps)
constexpr auto powers = [] {
  std::array<DoubleDouble, steps> all{};
  const DoubleDouble step = exp_series(ln_2 * (1.0 / steps));
  all[0] = {1.0, 0.0};
  for (std::size_t i = 1; i < all.size(); ++i) all[i] = all[i - 1] * step;
  return all;
}();

/// exp(x) - 1 for |x| < 0.003.
double expm1_near_0(double x) {
  return x + x * x *
                 ((1.0 / 2) + x * (1.0 / 6) +
                  x * x * ((1.0 / 24) + x * (1.0 / 120) + x * x * (1.0 / 720)));
}

/// The nearest whole number of a number below 2^31, as both kinds.
struct Whole {
  double value;
  std::int32_t number;
};
Whole nearest_whole(double x) {
  constexpr double ones_are_last = 0x1.8p52;
  const double shifted = x + ones_are_last;
  return {shifted - ones_are_last,
          static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(shifted))};
}

Scaled of_steps(std::int32_t n, double rest) {
  const DoubleDouble& power = powers[static_cast<std::size_t>(n & (steps - 1))];
  return {ordered_sum(power.high, power.low + power.high * expm1_near_0(rest)), n >> 7};
}

double power_of_2(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// exp(x) - 1, exact to 2^-60 of it, for 0.015 < |x| < 50.
DoubleDouble expm1_apart(double x) {
  const Scaled power = scaled_exp({x, 0.0});
  const double scale = power_of_2(power.exponent);
  const DoubleDouble high = exact_sum(power.number.high * scale, -1.0);
  return ordered_sum(high.high, high.low + power.number.low * scale);
}

/// The same for |x| <= 0.015, by the series.
DoubleDouble expm1_series(double x) {
  const double rest =
      x * x *
      ((1.0 / 2) +
       x * ((1.0 / 6) +
            x * ((1.0 / 24) +
                 x * ((1.0 / 120) + x * ((1.0 / 720) + x * ((1.0 / 5040) + x * (1.0 / 40320)))))));
  return ordered_sum(x, rest);
}

constexpr double near_0 = 0.015;

}  // namespace

Scaled scaled_exp(DoubleDouble x) {
  // ln 2 / steps in two parts, the first one of 33 bits.
  constexpr double first = 0x1.62e42fef00000p-8;
  constexpr double second = 0x1.473de6af278edp-41;
  const Whole n = nearest_whole(x.high * (steps * 0x1.71547652b82fep+0));
  return of_steps(n.number, ((x.high - n.value * first) - n.value * second) + x.low);
}

double rounded(const Scaled& scaled) {
  const double number = scaled.number.high;
  if (scaled.exponent > -1022 && scaled.exponent < 1023)
    return number * power_of_2(scaled.exponent);
  return std::ldexp(number, scaled.exponent);
}

double exp(double x) {
  if (std::abs(x) < 800.0) return rounded(scaled_exp({x, 0.0}));
  if (std::isnan(x)) return x;
  return x > 0.0 ? infinity : 0.0;
}

double exp2(double x) {
  if (std::abs(x) < 1200.0) {
    const Whole n = nearest_whole(x * steps);
    return rounded(of_steps(n.number, (x - n.value * (1.0 / steps)) * ln_2.high));
  }
  if (std::isnan(x)) return x;
  return x > 0.0 ? infinity : 0.0;
}

double expm1(double x) {
  if (std::abs(x) < 1e-17) return x;
  if (std::abs(x) <= near_0) return expm1_series(x).high;
  if (x < -40.0) return -1.0;
  if (std::abs(x) < 50.0) return expm1_apart(x).high;
  return exp(x);
}

double tanh(double x) {
  const double size = std::abs(x);
  if (size < 1e-9) return x;
  if (size > 20.0) return std::copysign(1.0, x);
  if (std::isnan(x)) return x;
  const DoubleDouble e = 2.0 * size <= near_0 ? expm1_series(2.0 * size) : expm1_apart(2.0 * size);
  return std::copysign((e / (e + DoubleDouble{2.0, 0.0})).high, x);
}

}  // namespace wold::math
