#pragma once

#include <cmath>
#include <cstdint>

/// Phases in turns, for loops over millions of flakes: without branches and library calls, the same
/// on every machine.
namespace wold {

/// What is left of x beside the nearest whole number, in [-0.5, 0.5]; |x| < 2^51. Adding 1.5 * 2^52
/// rounds to a whole number.
inline double off_whole(double x) {
  constexpr double rounder = 0x1.8p52;
  return x - ((x + rounder) - rounder);
}

/// What is left of x beside the whole number below, in units of 2^-64.
inline std::uint64_t fraction_of(double x) {
  return static_cast<std::uint64_t>((x - std::floor(x)) * 0x1p64);
}

/// The same in units of 2^-32: sums of such overflow as turns wrap round.
inline std::uint32_t turn_of(double x) { return static_cast<std::uint32_t>(fraction_of(x) >> 32); }

/// cos(2 pi turns) within 7e-7 and the rounding of `turns`; |turns| < 2^22. It is sin(2 pi t) for
/// t = 1/4 - |turns|, by the polynomial of the seventh degree whose greatest error is the least
/// there (Remez 1934), 6e-7.
inline float cosine_of_turns(float turns) {
  constexpr float rounder = 0x1.8p23F;
  const float rest = turns - ((turns + rounder) - rounder);
  const float t = 0.25F - std::abs(rest);
  const float t2 = t * t;
  return t * (6.28316402F + t2 * (-41.3371429F + t2 * (81.3407669F + t2 * -70.9934311F)));
}

inline float sine_of_turns(float turns) { return cosine_of_turns(turns - 0.25F); }

}  // namespace wold
