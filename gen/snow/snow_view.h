#pragma once

#include <cmath>
#include <glm/glm.hpp>

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
  const glm::dvec3& ahead() const { return ahead_; }
  /// Whether any of a ball is seen (or nearly, about the pyramid's edges).
  bool touches(const glm::dvec3& centre_m, double radius_m) const {
    const glm::dvec3 from_eye = centre_m - eye_m_;
    const double depth = glm::dot(from_eye, ahead_);
    return depth > -radius_m &&
           std::abs(glm::dot(from_eye, right_)) <= half_width_ * depth + slant_width_ * radius_m &&
           std::abs(glm::dot(from_eye, up_)) <= half_height_ * depth + slant_height_ * radius_m;
  }
  double solid_angle_sr() const;
  /// Between the middle and a corner of the picture.
  double half_angle() const;
  /// What a pixel covers at a distance of 1 m.
  double pixel_angle() const { return pixel_angle_; }

 private:
  glm::dvec3 eye_m_, ahead_, right_, up_;
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
