#pragma once

#include <glm/glm.hpp>

#include "core/pinhole.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// A pinhole camera over a picture: world space to pixels and back. x to the right, y down; depth
/// in metres along the line of sight of the picture's middle.
class Perspective {
 public:
  Perspective(const Camera& camera, const glm::ivec2& size_px)
      : eye_m_(camera.eye_m),
        axes_(camera.eye_m, camera.target_m),
        focal_px_(pixels_per_radian(camera.field_of_view_deg, size_px.x)),
        middle_px_(0.5 * glm::dvec2(size_px)) {}

  const glm::dvec3& eye_m() const { return eye_m_; }
  /// Pixels that a metre covers at a depth.
  double pixels_per_m(double depth_m) const { return focal_px_ / depth_m; }

  /// x and y in pixels, z the depth, which is to be larger than 0 before the others mean anything.
  glm::dvec3 seen(const glm::dvec3& at_m) const {
    const glm::dvec3 away = at_m - eye_m_;
    const double depth_m = glm::dot(away, axes_.forward);
    const double scale = focal_px_ / depth_m;
    return {middle_px_.x + scale * glm::dot(away, axes_.right),
            middle_px_.y - scale * glm::dot(away, axes_.up), depth_m};
  }

  /// Unit direction that a place in the picture looks to.
  glm::dvec3 direction(const glm::dvec2& at_px) const {
    const glm::dvec2 from_middle = (at_px - middle_px_) / focal_px_;
    return glm::normalize(axes_.forward + axes_.right * from_middle.x - axes_.up * from_middle.y);
  }

  double depth_along(const glm::dvec3& direction) const {
    return glm::dot(direction, axes_.forward);
  }

 private:
  glm::dvec3 eye_m_;
  CameraAxes axes_;
  double focal_px_;
  glm::dvec2 middle_px_;
};

}  // namespace wold::landscape
