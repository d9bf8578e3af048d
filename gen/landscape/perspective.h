#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "core/elementary.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// A pinhole camera over a picture: world space to pixels and back. x to the right, y down; depth
/// in metres along the line of sight of the picture's middle.
class Perspective {
 public:
  Perspective(const Camera& camera, const glm::ivec2& size_px)
      : eye_m_(camera.eye_m),
        forward_(glm::normalize(camera.target_m - camera.eye_m)),
        right_(glm::normalize(glm::cross(forward_, glm::dvec3(0.0, 0.0, 1.0)))),
        up_(glm::cross(right_, forward_)),
        focal_px_(0.5 * size_px.x / math::tan(camera.field_of_view_deg * std::numbers::pi / 360.0)),
        middle_px_(0.5 * glm::dvec2(size_px)) {}

  const glm::dvec3& eye_m() const { return eye_m_; }
  /// Pixels that a metre covers at a depth.
  double pixels_per_m(double depth_m) const { return focal_px_ / depth_m; }

  /// x and y in pixels, z the depth, which is to be larger than 0 before the others mean anything.
  glm::dvec3 seen(const glm::dvec3& at_m) const {
    const glm::dvec3 away = at_m - eye_m_;
    const double depth_m = glm::dot(away, forward_);
    const double scale = focal_px_ / depth_m;
    return {middle_px_.x + scale * glm::dot(away, right_),
            middle_px_.y - scale * glm::dot(away, up_), depth_m};
  }

  /// Unit direction that a place in the picture looks to.
  glm::dvec3 direction(const glm::dvec2& at_px) const {
    const glm::dvec2 from_middle = (at_px - middle_px_) / focal_px_;
    return glm::normalize(forward_ + right_ * from_middle.x - up_ * from_middle.y);
  }

  double depth_along(const glm::dvec3& direction) const { return glm::dot(direction, forward_); }

 private:
  glm::dvec3 eye_m_;
  glm::dvec3 forward_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  double focal_px_;
  glm::dvec2 middle_px_;
};

}  // namespace wold::landscape
