#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/double_double.h"
#include "core/elementary.h"

namespace wold::math {
namespace {

/// x = quarters pi / 2 + angle, |angle| <= pi / 4 and a little.
struct Reduced {
  DoubleDouble angle;
  unsigned quarters = 0;  ///< modulo 4
};

/// By pi / 2 in three parts, whose first two have 33 bits: Cody and Waite, Software Manual for the
/// Elementary Functions (1980). |x| < 2^19.
Reduced reduce_small(double x) {
  constexpr double ones_are_last = 0x1.8p52;
  const double shifted = x * 0x1.45f306dc9c883p-1 + ones_are_last;  // 2 / pi
  const double n = shifted - ones_are_last;
  const DoubleDouble rest = exact_sum(x - n * 0x1.921fb54400000p+0, n * -0x1.0b4611a600000p-34);
  const DoubleDouble angle = exact_sum(rest.high, n * -0x1.3198a2e037073p-69);
  return {ordered_sum(angle.high, angle.low + rest.low),
          static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted)) & 3U};
}

/// Bits of 2 / pi behind the point, after 64 zeros.
constexpr std::array<std::uint64_t, 20> two_over_pi = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
    0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
    0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
    0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

/// 32 bits from bit `place` of two_over_pi on.
std::uint64_t word_at(int place) {
  const auto at = static_cast<std::size_t>(place / 64);
  const int shift = place % 64;
  const std::uint64_t both =
      shift <= 32 ? two_over_pi[at] >> (32 - shift)
                  : two_over_pi[at] << (shift - 32) | two_over_pi[at + 1] >> (96 - shift);
  return both & 0xffffffffULL;
}

/// x 2 / pi modulo 4 with those bits of 2 / pi alone that matter to it: Payne and Hanek, "Radian
/// reduction for trigonometric functions" (1983). |x| >= 2^19, finite.
Reduced reduce_large(double x) {
  constexpr std::size_t words = 6;  // 2 bits before the point, 190 behind it
  int exponent = 0;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const std::uint64_t front = digits >> 32;
  const std::uint64_t back = digits & 0xffffffffULL;
  const int place = 64 + (exponent - 53) - 2;
  std::array<std::uint64_t, words + 1> product{};  // 32 bits each, the first one beyond the range
  for (std::size_t i = words; i > 0; --i) {
    const std::uint64_t word = word_at(place + 32 * (static_cast<int>(i) - 1));
    product[i] += word * back;
    product[i - 1] += product[i] >> 32;
    product[i] &= 0xffffffffULL;
    if (i > 1) product[i - 1] += (word * front) & 0xffffffffULL;
    if (i > 2) product[i - 2] += (word * front) >> 32;
  }
  for (std::size_t i = words; i > 0; --i) {
    product[i - 1] += product[i] >> 32;
    product[i] &= 0xffffffffULL;
  }
  // To the nearest quarter; what is left may be negative.
  const std::uint64_t quarters = (product[1] + (1U << 29)) >> 30;
  DoubleDouble turn{static_cast<double>(product[1]) - static_cast<double>(quarters << 30), 0.0};
  double unit = 1.0;
  for (std::size_t i = 2; i <= words; ++i) {
    unit *= 0x1p-32;
    turn = turn + DoubleDouble{static_cast<double>(product[i]) * unit, 0.0};
  }
  const DoubleDouble angle = turn * 0x1p-30 * half_pi;
  const auto turned = static_cast<unsigned>(quarters);
  return x < 0.0 ? Reduced{-angle, (0U - turned) & 3U} : Reduced{angle, turned & 3U};
}

Reduced reduced(double x) {
  constexpr double quarter_pi = 0.78;
  if (std::abs(x) < quarter_pi) return {{x, 0.0}, 0};
  return std::abs(x) < 0x1p19 ? reduce_small(x) : reduce_large(x);
}

// Taylor's series; of |x| < 0.79 the terms left out are below 2^-60.

DoubleDouble sine(DoubleDouble x) {
  const double z = x.high * x.high;
  const double z2 = z * z;
  const double after_third =
      ((1.0 / 120) - z * (1.0 / 5040)) +
      z2 * (((1.0 / 362880) - z * (1.0 / 39916800)) +
            z2 * ((1.0 / 6227020800) - z * (1.0 / 1307674368000) + z2 * (1.0 / 355687428096000)));
  const double rest = x.high * z * (z * after_third - (1.0 / 6)) + x.low * (1.0 - 0.5 * z);
  return ordered_sum(x.high, rest);
}

DoubleDouble cosine(DoubleDouble x) {
  const double z = x.high * x.high;
  const double z2 = z * z;
  const double from_fourth =
      z2 *
      (((1.0 / 24) - z * (1.0 / 720)) +
       z2 * (((1.0 / 40320) - z * (1.0 / 3628800)) +
             z2 * ((1.0 / 479001600) - z * (1.0 / 87178291200) + z2 * (1.0 / 20922789888000))));
  const DoubleDouble square = exact_product(x.high, x.high);
  const DoubleDouble front = ordered_sum(1.0, -0.5 * square.high);
  return ordered_sum(front.high, front.low - 0.5 * square.low + from_fourth - x.high * x.low);
}

/// The same of a float: no float below 2^19 is so near a whole number of quarters that doubles do
/// not do.
struct ReducedFloat {
  double angle = 0.0;
  unsigned quarters = 0;
};

ReducedFloat reduced_float(double x) {
  constexpr double ones_are_last = 0x1.8p52;
  const double shifted = x * 0x1.45f306dc9c883p-1 + ones_are_last;
  const double n = shifted - ones_are_last;
  return {(x - n * 0x1.921fb54400000p+0) - n * 0x1.0b4611a626331p-34,
          static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted)) & 3U};
}

/// sin(x) for |x| < 0.79, to 2^-37 of it.
double short_sine(double x) {
  const double z = x * x;
  const double z2 = z * z;
  return x - x * z *
                 (((1.0 / 6) - z * (1.0 / 120)) +
                  z2 * ((1.0 / 5040) - z * (1.0 / 362880) + z2 * (1.0 / 39916800)));
}

/// cos(x) for |x| < 0.79, to 2^-39.
double short_cosine(double x) {
  const double z = x * x;
  const double z2 = z * z;
  return 1.0 - z * (0.5 - z * (1.0 / 24)) -
         z2 * z *
             (((1.0 / 720) - z * (1.0 / 40320)) + z2 * ((1.0 / 3628800) - z * (1.0 / 479001600)));
}

/// sin(x + shift pi / 2)
float shifted_sine(float x, unsigned shift) {
  const auto [angle, quarters] = reduced_float(x);
  const unsigned turned = quarters + shift;
  const double value = turned % 2 == 0 ? short_sine(angle) : short_cosine(angle);
  return static_cast<float>((turned & 2U) == 0 ? value : -value);
}

double not_a_number(double x) { return x - x; }

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return not_a_number(x);
  if (std::abs(x) < 1e-9) return x;
  const auto [angle, quarters] = reduced(x);
  const DoubleDouble value = quarters % 2 == 0 ? sine(angle) : cosine(angle);
  return quarters < 2 ? value.high : -value.high;
}

double cos(double x) {
  if (!std::isfinite(x)) return not_a_number(x);
  const auto [angle, quarters] = reduced(x);
  const DoubleDouble value = quarters % 2 == 0 ? cosine(angle) : sine(angle);
  return quarters == 0 || quarters == 3 ? value.high : -value.high;
}

float sin(float x) {
  if (x == 0.0F) return x;
  return std::abs(x) < 0x1p19F ? shifted_sine(x, 0) : static_cast<float>(sin(double{x}));
}

float cos(float x) {
  return std::abs(x) < 0x1p19F ? shifted_sine(x, 1) : static_cast<float>(cos(double{x}));
}

double tan(double x) {
  if (!std::isfinite(x)) return not_a_number(x);
  if (std::abs(x) < 1e-9) return x;
  const auto [angle, quarters] = reduced(x);
  const DoubleDouble s = sine(angle);
  const DoubleDouble c = cosine(angle);
  return quarters % 2 == 0 ? (s / c).high : (-c / s).high;
}

}  // namespace wold::math
