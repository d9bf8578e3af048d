#pragma once

#include <complex>
#include <vector>

namespace wold::wind {

/// A square of complex numbers, `side` a power of two, row by row.
struct ComplexSquare {
  int side = 0;
  std::vector<std::complex<double>> values;
};

/// The discrete Fourier transform of both axes, sum f(x) exp(-2 pi i k x / side), in place
/// (Cooley and Tukey 1965). Throws std::invalid_argument when the side is no power of two.
void transform(ComplexSquare& square);

/// Its inverse: transform() and this leave everything as it was.
void transform_back(ComplexSquare& square);

}  // namespace wold::wind
