#pragma once

#include <complex>

#include "core/elementary.h"

namespace wold {

/// Polar coordinates by core/elementary.h; those of <complex> are the C library's.
inline std::complex<double> from_polar(double length, double angle_rad) {
  return {length * math::cos(angle_rad), length * math::sin(angle_rad)};
}
inline double length_of(const std::complex<double>& z) { return math::hypot(z.real(), z.imag()); }
inline double angle_of(const std::complex<double>& z) { return math::atan2(z.imag(), z.real()); }

}  // namespace wold
