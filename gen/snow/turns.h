#pragma once

#include <cstdint>

/// Phases in turns, for loops over millions of flakes: sines without a library call, the same on
/// every machine.
namespace wold::snow {

/// x - floor(x), for |x| < 2^62.
inline double fraction(double x) {
  const double rest = x - static_cast<double>(static_cast<std::int64_t>(x));
  return rest < 0.0 ? rest + 1.0 : rest;
}

/// sin(2 pi turns) within 4e-6: its Taylor series to the ninth order on a quarter turn.
inline float sine_of_turns(double turns) {
  auto x = static_cast<float>(fraction(turns) - 0.5);  // half a turn on: the sign changes
  if (x > 0.25F) x = 0.5F - x;
  if (x < -0.25F) x = -0.5F - x;
  const float a = x * 6.28318531F;
  const float b = a * a;
  return -a * (1.0F + b * (-1.0F / 6.0F +
                           b * (1.0F / 120.0F + b * (-1.0F / 5040.0F + b * (1.0F / 362880.0F)))));
}

inline float cosine_of_turns(double turns) { return sine_of_turns(turns + 0.25); }

}  // namespace wold::snow
