#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/double_double.h"
#include "core/elementary.h"

namespace wold::math {
namespace {

// atan(y / x) = atan(c) + atan((y - c x) / (x + c y)) with c = i / parts near y / x.
constexpr int parts = 16;

/// atan(x) for 0 <= x <= 1 / 16.
constexpr DoubleDouble arctangent_series(DoubleDouble x) {
  const DoubleDouble square = x * x;
  DoubleDouble sum{};
  for (int n = 27; n > 0; n -= 2)
    sum = DoubleDouble{1.0, 0.0} / DoubleDouble{1.0 * n, 0.0} + -(sum * square);
  return sum * x;
}

/// atan(i / parts)
constexpr auto arctangents = [] {
  std::array<DoubleDouble, parts + 1> all{};
  for (std::size_t i = 0; i < parts; ++i) {
    const double product = static_cast<double>(i * (i + 1)) / (parts * parts);
    all[i + 1] = all[i] + arctangent_series(DoubleDouble{1.0 / parts, 0.0} /
                                            DoubleDouble{1.0 + product, 0.0});
  }
  return all;
}();

/// atan(t) - t for |t| < 0.065.
double arctangent_from_third_power(double t) {
  const double z = t * t;
  const double z2 = z * z;
  return t * z *
         ((z * (1.0 / 5) - (1.0 / 3)) +
          z2 * ((z * (1.0 / 9) - (1.0 / 7)) + z2 * ((z * (1.0 / 13) - (1.0 / 11)))));
}

/// atan(y / x) for 0 <= y <= x, x from 2^-900 to 2^900.
DoubleDouble angle_in_octant(double y, double x) {
  const double ratio = y / x;
  const int i = ratio < 1.0 / parts ? 0 : static_cast<int>(ratio * parts + 0.5);
  if (i == 0) {
    const DoubleDouble back = exact_product(ratio, x);
    const double rest = ((y - back.high) - back.low) / x;
    return ordered_sum(ratio, rest + arctangent_from_third_power(ratio));
  }
  const double c = 1.0 * i / parts;
  const DoubleDouble half = halves(x);  // c has 5 bits: its products with them are exact
  const double t = ((y - c * half.high) - c * half.low) / (x + c * y);
  const DoubleDouble& start = arctangents[static_cast<std::size_t>(i)];
  const DoubleDouble sum = ordered_sum(start.high, t);
  return ordered_sum(sum.high, sum.low + (start.low + arctangent_from_third_power(t)));
}

/// The angle of (x, y) from (1, 0), for x and y >= 0 and not both 0.
DoubleDouble angle_in_quadrant(double y, double x) {
  return y <= x ? angle_in_octant(y, x) : half_pi + -angle_in_octant(x, y);
}

constexpr DoubleDouble twice(DoubleDouble x) { return {2.0 * x.high, 2.0 * x.low}; }

/// asin(x) - x for |x| <= 0.5: x^3 times the polynomial in x^2 that interpolates the rest at
/// Chebyshev's points, to 2^-57.
double arcsine_from_third_power(double x) {
  const double z = x * x;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double low = (0x1.5555555555556p-3 + z * 0x1.3333333332ec4p-4) +
                     z2 * (0x1.6db6db6e3292ep-5 + z * 0x1.f1c71c1d4aa0dp-6);
  const double middle = (0x1.6e8bb1d89492bp-6 + z * 0x1.1c4d343fa57f6p-6) +
                        z2 * (0x1.c9cf3759fd8ffp-7 + z * 0x1.78246f32d075cp-7);
  const double high = (0x1.524ea8b3aad31p-7 + z * 0x1.653a8f8cfd43cp-8) +
                      z2 * (0x1.1d661531b222ep-6 + z * -0x1.e7a24f548c99fp-7) +
                      z4 * 0x1.d78189767524ep-6;
  return x * z * (low + z4 * (middle + z4 * high));
}

/// asin(sqrt(z)) for 0 <= z <= 0.25.
DoubleDouble arcsine_of_root(double z) {
  if (z == 0.0) return {};
  const double root = std::sqrt(z);
  const DoubleDouble half = halves(root);
  const double rest = ((z - half.high * half.high) - half.low * (root + half.high)) / (2.0 * root);
  return ordered_sum(root, rest + arcsine_from_third_power(root));
}

double signed_angle(const DoubleDouble& in_quadrant, double y, double x) {
  const DoubleDouble angle = std::signbit(x) ? twice(half_pi) + -in_quadrant : in_quadrant;
  return std::copysign(angle.high, y);
}

}  // namespace

double atan(double x) {
  const double size = std::abs(x);
  if (size < 1e-9 || std::isnan(x)) return x;
  if (size > 1e17) return std::copysign(half_pi.high, x);
  return std::copysign(angle_in_quadrant(size, 1.0).high, x);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  double up = std::abs(y);
  double along = std::abs(x);
  if (up == 0.0) return signed_angle({}, y, x);
  if (std::isinf(up) || std::isinf(along)) {
    up = std::isinf(up) ? 1.0 : 0.0;
    along = std::isinf(along) ? 1.0 : 0.0;
  }
  const double larger = std::max(up, along);
  if (larger > 0x1p500 || larger < 0x1p-500) {
    const double scale = larger > 1.0 ? 0x1p-600 : 0x1p500;
    up *= scale;
    along *= scale;
  }
  // Beyond that the smaller one does not show, or is all that does.
  if (up < along * 0x1p-60 && !std::signbit(x)) return std::copysign(up / along, y);
  return signed_angle(angle_in_quadrant(up, along), y, x);
}

double asin(double x) {
  const double size = std::abs(x);
  if (size < 1e-9) return x;
  if (!(size <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
  if (size <= 0.5) return x + arcsine_from_third_power(x);
  return std::copysign((half_pi + twice(-arcsine_of_root(0.5 - 0.5 * size))).high, x);
}

double acos(double x) {
  if (!(std::abs(x) <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
  if (std::abs(x) <= 0.5) {
    const DoubleDouble front = ordered_sum(half_pi.high, -x);
    return front.high + (front.low + half_pi.low - arcsine_from_third_power(x));
  }
  const DoubleDouble half = arcsine_of_root(0.5 - 0.5 * std::abs(x));
  return x > 0.0 ? 2.0 * half.high : (twice(half_pi) + twice(-half)).high;
}

}  // namespace wold::math
