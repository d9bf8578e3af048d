#pragma once

#include "core/double_double.h"

namespace wold::math {

/// A number times a power of two, which may leave the range of doubles.
struct Scaled {
  DoubleDouble number;  ///< from 0.99 to 2, with an error of 2^-61
  int exponent = 0;
};

/// exp(x) for |x| < 2000.
Scaled scaled_exp(DoubleDouble x);

/// Rounded once where the result is a normal number.
double rounded(const Scaled& scaled);

}  // namespace wold::math
