#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "core/ground_map.h"

/// Lines of sight over land, each in a vertical plane.
namespace wold::ground {

/// Clockwise from north.
inline double azimuth_rad(const glm::dvec3& direction) {
  return math::atan2(direction.x, direction.y);
}

/// In [-pi, pi].
inline double turned_rad(double rad) { return std::remainder(rad, 2.0 * std::numbers::pi); }

/// How far it is from a place in a square to its border, along a level unit direction.
inline double to_border_m(const Square& square, const glm::dvec2& from_m,
                          const glm::dvec2& towards) {
  double distance_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    if (towards[axis] == 0.0) continue;
    const double border_m = square.corner_m[axis] + (towards[axis] > 0.0 ? square.size_m : 0.0);
    distance_m = std::min(distance_m, (border_m - from_m[axis]) / towards[axis]);
  }
  return std::max(distance_m, 0.0);
}

/// How much lower the round earth's ground looks than flat ground would.
inline double drop_m(double distance_m) {
  constexpr double earth_radius_m = 6.371e6, refraction = 0.13;
  return (1.0 - refraction) / (2.0 * earth_radius_m) * distance_m * distance_m;
}

}  // namespace wold::ground
