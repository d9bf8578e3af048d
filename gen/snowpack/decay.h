#pragma once

#include <bit>
#include <cstdint>

namespace wold::snowpack {

/// By value: the compiler takes std::min and std::max for branches where they stand in loops.
constexpr double lesser(double a, double b) { return a < b ? a : b; }
constexpr double greater(double a, double b) { return a > b ? a : b; }

/// exp(-x) for x >= 0 within 1e-11 of itself, at least 1e-300: without branches and calls, so that
/// loops over many places do several at once.
inline double decay(double x) {
  constexpr double log2_e = 1.4426950408889634, whole = 0x1.8p52;  // adding it rounds to integers
  constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
  const double exponent = greater(-x, -690.0);
  const double shifted = exponent * log2_e + whole;
  const double twos = shifted - whole;
  const double r = (exponent - twos * ln2_high) - twos * ln2_low;  // in +-ln(2) / 2
  // The series to r^9, in pairs: processors wait for less than they do in Horner's scheme.
  const double r2 = r * r, r4 = r2 * r2;
  const double first = (1.0 + r) + r2 * (1.0 / 2.0 + r * (1.0 / 6.0));
  const double second = (1.0 / 24.0 + r * (1.0 / 120.0)) + r2 * (1.0 / 720.0 + r * (1.0 / 5040.0));
  const double third = 1.0 / 40320.0 + r * (1.0 / 362880.0);
  const double power = first + r4 * (second + r4 * third);
  constexpr std::uint64_t bias = 1023, exponent_place = 52;
  return power *
         std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + bias) << exponent_place);
}

}  // namespace wold::snowpack
