#pragma once

#include <algorithm>
#include <array>

#include "core/angle.h"

/// The sun's disc as hills cover it. It is taken as 2 degrees wide: grass, not a sharp edge, casts
/// a hill's shadow.
namespace wold::terrain::sun_disc {

inline constexpr double half_width_rad = 1.0 * radians_per_degree;

/// Azimuths that stand for the disc's width, from its middle.
inline constexpr std::array<double, 3> offsets_rad = {-0.7 * radians_per_degree, 0.0,
                                                      0.7 * radians_per_degree};

/// Fraction of the disc that is seen where a fraction of its height is, both in [0, 1].
inline double seen(double height_fraction) {
  const double t = std::clamp(height_fraction, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace wold::terrain::sun_disc
