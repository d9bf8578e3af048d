#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "core/pinhole.h"

namespace wold::snow {

/// Who looks at the snow: a camera whose up is +z.
struct SnowView {
  glm::dvec3 eye_m{0.0};
  glm::dvec3 target_m{0.0, 1.0, 0.0};
  double field_of_view_deg = 55.0;  ///< horizontal, below 180
  int width_px = 960;
  int height_px = 540;
};

/// The pyramid that a view sees.
class Frustum {
 public:
  explicit Frustum(const SnowView& view);

  const glm::dvec3& eye_m() const { return eye_m_; }
  const glm::dvec3& ahead() const { return axes_.forward; }
  /// Whether any of a ball is seen (or nearly, about the pyramid's edges).
  bool touches(const glm::dvec3& centre_m, double radius_m) const {
    return touches_from_eye(centre_m - eye_m_, radius_m);
  }
  /// The same of a place relative to the eye, in its precision and without branches.
  template <class Vector>
  bool touches_from_eye(const Vector& centre_m, typename Vector::value_type radius_m) const {
    using Number = typename Vector::value_type;
    const Number depth = glm::dot(centre_m, Vector(axes_.forward));
    const Number beside = std::abs(glm::dot(centre_m, Vector(axes_.right)));
    const Number above = std::abs(glm::dot(centre_m, Vector(axes_.up)));
    return static_cast<bool>(
        static_cast<int>(depth > -radius_m) &
        static_cast<int>(beside <= Number(half_width_) * depth + Number(slant_width_) * radius_m) &
        static_cast<int>(above <= Number(half_height_) * depth + Number(slant_height_) * radius_m));
  }
  /// Where a place ahead, relative to the eye, is in the picture: from -1 to 1 to the right and up.
  glm::dvec2 in_picture(const glm::dvec3& from_eye_m) const {
    const double depth_m = glm::dot(from_eye_m, axes_.forward);
    return {glm::dot(from_eye_m, axes_.right) / (depth_m * half_width_),
            glm::dot(from_eye_m, axes_.up) / (depth_m * half_height_)};
  }
  double solid_angle_sr() const;
  /// Between the middle and a corner of the picture.
  double half_angle() const;
  /// What a pixel covers at a distance of 1 m.
  double pixel_angle() const { return pixel_angle_; }

 private:
  glm::dvec3 eye_m_;
  CameraAxes axes_;
  double half_width_, half_height_;    ///< of the picture, one metre ahead
  double slant_width_, slant_height_;  ///< from the eye to there, where the other one is 0
  double pixel_angle_;
};

/// The sides of an upright rectangle.
struct Facing {
  glm::vec3 right;
  glm::vec3 up;
};

/// Unit vectors across `towards_eye`, itself one; `right` is level.
Facing facing(const glm::vec3& towards_eye);

}  // namespace wold::snow
