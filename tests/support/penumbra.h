#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/constant_meadow.h"

namespace wold::test {

/// Fraction of a disc that lies beyond a straight edge, `offset` radii from the disc's middle.
inline double circular_segment(double offset) {
  const double x = std::clamp(offset, -1.0, 1.0);
  return (std::acos(x) - x * std::sqrt(1.0 - x * x)) / std::numbers::pi;
}

/// Fraction of the sun's light that a roof takes from what is seen from above of a meadow of fog on
/// level ground, x metres east of where the edge of its shadow meets the ground. The roof is 30 m
/// up and the sun 45 degrees high in the west: at a height h the edge lies h farther west, and the
/// disc blurs it by 30 m * sqrt(2) * 0.00465 rad, seen at 45 degrees.
inline double penumbra(const ConstantMeadow& fog, double height_m, double x_m) {
  const double blur_m = 2.0 * 30.0 * 0.00465;
  const auto hidden = [&](double h_m) { return circular_segment((x_m + h_m) / blur_m); };
  const auto through = [&](double depth_m) { return std::exp(-double{fog.extinction} * depth_m); };
  double taken = fog.ground * through(height_m) * hidden(0.0);
  double seen = fog.ground * through(height_m);
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const double h_m = (i + 0.5) / steps * height_m;
    const double light = fog.radiance * fog.extinction * through(height_m - h_m) * height_m / steps;
    taken += light * hidden(h_m);
    seen += light;
  }
  return taken / seen;
}

}  // namespace wold::test
