#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// Phases in turns, for loops over millions of flakes: without branches and library calls, the same
/// on every machine.
namespace wold::snow {

/// What is left of x beside the nearest whole number, in [-0.5, 0.5]; |x| < 2^51. Adding 1.5 * 2^52
/// rounds to a whole number.
inline double off_whole(double x) {
  constexpr double rounder = 0x1.8p52;
  return x - ((x + rounder) - rounder);
}

/// cos(2 pi turns) within 4e-6 and the rounding of `turns`; |turns| < 2^22. It is sin(2 pi t) for
/// t = 1/4 - |turns|, by the Taylor series to the ninth order.
inline float cosine_of_turns(float turns) {
  constexpr float rounder = 0x1.8p23F;
  const float rest = turns - ((turns + rounder) - rounder);
  const float t = 0.25F - std::abs(rest);
  const float a = t * 6.28318531F;
  const float b = a * a;
  return a * (1.0F + b * (-1.0F / 6.0F +
                          b * (1.0F / 120.0F + b * (-1.0F / 5040.0F + b * (1.0F / 362880.0F)))));
}

inline float sine_of_turns(float turns) { return cosine_of_turns(turns - 0.25F); }

/// Sines of all the turns, then their cosines: four or more at a time.
template <std::size_t count>
std::array<float, 2 * count> sines_and_cosines(const std::array<float, count>& turns) {
  std::array<float, 2 * count> both;
  for (std::size_t i = 0; i < count; ++i) {
    both[i] = turns[i] - 0.25F;
    both[count + i] = turns[i];
  }
  for (float& value : both) value = cosine_of_turns(value);
  return both;
}

}  // namespace wold::snow
