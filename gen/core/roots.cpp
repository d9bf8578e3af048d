#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/double_double.h"
#include "core/elementary.h"

namespace wold::math {
double cbrt(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const int thirds = (exponent + 3 * 1024) % 3;
  const double part = std::ldexp(fraction, thirds);  // from 0.5 to 4
  // A third of the exponent for a start, and Newton's steps; the last one from an exact remainder.
  constexpr std::uint64_t two_thirds_of_bias = 0x2a9f7893782da1ceULL;
  auto root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(part) / 3 + two_thirds_of_bias);
  for (int step = 0; step < 4; ++step) root -= (root - part / (root * root)) / 3.0;
  const DoubleDouble square = exact_product(root, root);
  const DoubleDouble cube = square * root;
  root -= ((cube.high - part) + cube.low) / (3.0 * square.high);
  return std::copysign(std::ldexp(root, (exponent - thirds) / 3), x);
}

double hypot(double x, double y) { return hypot(x, y, 0.0); }

double hypot(double x, double y, double z) {
  if (std::isinf(x) || std::isinf(y) || std::isinf(z))
    return std::numeric_limits<double>::infinity();
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (largest == 0.0 || std::isnan(x + y + z)) return x + y + z == 0.0 ? 0.0 : x + y + z;
  if (largest > 0x1p400) return hypot(x * 0x1p-600, y * 0x1p-600, z * 0x1p-600) * 0x1p600;
  if (largest < 0x1p-400) return hypot(x * 0x1p600, y * 0x1p600, z * 0x1p600) * 0x1p-600;
  const auto squares = exact_product(x, x) + exact_product(y, y);
  return square_root(z == 0.0 ? squares : squares + exact_product(z, z)).high;
}

}  // namespace wold::math
