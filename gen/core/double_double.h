#pragma once

#include <cmath>

namespace wold::math {

/// A number of about 106 bits as a sum: `high` is the sum rounded, `low` what is missing.
/// Error-free transformations after Dekker, "A floating-point technique for extending the available
/// precision" (1971), and Knuth, The Art of Computer Programming 2, 4.2.2.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;
};

/// a + b exactly, where |a| >= |b| or a is 0.
constexpr DoubleDouble ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
constexpr DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a as two numbers of 26 bits; |a| < 2^996.
constexpr DoubleDouble halves(double a) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  const double high = c - (c - a);
  return {high, a - high};
}

/// a b exactly, where neither it nor its parts leave the range of normal numbers.
constexpr DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = halves(a);
  const DoubleDouble y = halves(b);
  const double rest =
      ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
  return {product, rest};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble sum = exact_sum(a.high, b.high);
  const DoubleDouble rest = exact_sum(a.low, b.low);
  const DoubleDouble nearly = ordered_sum(sum.high, sum.low + rest.high);
  return ordered_sum(nearly.high, nearly.low + rest.low);
}

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble product = exact_product(a.high, b);
  return ordered_sum(product.high, product.low + a.low * b);
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double inverse = 1.0 / b.high;
  const double quotient = a.high * inverse;
  const DoubleDouble back = exact_product(quotient, b.high);
  const double rest = ((a.high - back.high) - back.low + a.low) - quotient * b.low;
  return ordered_sum(quotient, rest * inverse);
}

/// Square root of a positive number.
inline DoubleDouble square_root(DoubleDouble a) {
  const double root = std::sqrt(a.high);
  const DoubleDouble back = exact_product(root, root);
  return ordered_sum(root, ((a.high - back.high) - back.low + a.low) / (2.0 * root));
}

inline constexpr DoubleDouble ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
inline constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

}  // namespace wold::math
