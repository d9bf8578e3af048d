#pragma once

#include <glm/glm.hpp>

#include "core/angle.h"
#include "core/elementary.h"

namespace wold {

/// The directions of a pinhole camera whose up is +z, as unit vectors.
struct CameraAxes {
  /// A camera at one place that looks at another one. One that looks straight up or down has the
  /// east on its right.
  CameraAxes(const glm::dvec3& eye_m, const glm::dvec3& target_m)
      : forward(glm::normalize(target_m - eye_m)),
        right(level_right(forward)),
        up(glm::cross(right, forward)) {}

  glm::dvec3 forward;
  glm::dvec3 right;  ///< level
  glm::dvec3 up;     ///< up in the picture

 private:
  static glm::dvec3 level_right(const glm::dvec3& forward) {
    const glm::dvec3 right = glm::cross(forward, glm::dvec3(0.0, 0.0, 1.0));
    return glm::length(right) > 1e-6 ? glm::normalize(right) : glm::dvec3(1.0, 0.0, 0.0);
  }
};

/// Half the width of what a pinhole camera with a horizontal field of view below 180 degrees sees,
/// one metre ahead, in metres.
inline double half_width(double field_of_view_deg) {
  return math::tan(radians(0.5 * field_of_view_deg));
}

/// Pixels that an angle of one radian covers in the middle of a pinhole camera's picture.
inline double pixels_per_radian(double field_of_view_deg, int width_px) {
  return width_px / (2.0 * half_width(field_of_view_deg));
}

}  // namespace wold
