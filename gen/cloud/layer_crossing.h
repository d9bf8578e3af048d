#pragma once

#include <cmath>

namespace wold::cloud {

/// Where a ray from the ground meets a sphere around the earth: the distance along the ray, and the
/// cosine between the ray and the vertical there.
struct Crossing {
  double distance_m;
  double cosine;
};

/// `rise_m`, > 0, is the sphere's height above the eye; `sine` that of the ray's elevation, >= 0.
inline Crossing crossing(double sine, double rise_m) {
  constexpr double earth_radius_m = 6.371e6;
  const double down_m = earth_radius_m * sine;
  const double beyond_m2 = rise_m * (2.0 * earth_radius_m + rise_m);
  // The difference of two large numbers, written so that it keeps its digits.
  const double distance_m = beyond_m2 / (down_m + std::sqrt(down_m * down_m + beyond_m2));
  return {distance_m, (down_m + distance_m) / (earth_radius_m + rise_m)};
}

}  // namespace wold::cloud
