#pragma once

#include <glm/glm.hpp>

#include "core/angle.h"
#include "core/elementary.h"

namespace wold::wind {

/// The mean wind at one moment.
struct Moment {
  double speed_m_s = 0.0;    ///< at reference_m over level ground
  double heading_deg = 0.0;  ///< where it blows to, clockwise from north
  double run_m = 0.0;        ///< how far it has blown by then: the integral of its speed
};

/// East and north as the wind has them: along it, and to its right.
struct Axes {
  explicit Axes(double heading_deg)
      : along(math::sin(heading_deg * radians_per_degree),
              math::cos(heading_deg * radians_per_degree)),
        right(along.y, -along.x) {}

  /// A vector of the wind's axes, on the ground.
  glm::dvec2 on_ground(const glm::dvec2& in_wind) const {
    return in_wind.x * along + in_wind.y * right;
  }

  glm::dvec2 along, right;
};

}  // namespace wold::wind
