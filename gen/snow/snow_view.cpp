#include "snow/snow_view.h"

#include <cmath>

#include "core/elementary.h"

namespace wold::snow {
namespace {

/// Level, to the right of `along`; east where that is vertical.
glm::vec3 level_across(const glm::vec3& along) {
  const float length = std::sqrt(along.x * along.x + along.y * along.y);
  if (!(length > 1e-6F)) return {1.0F, 0.0F, 0.0F};
  const float scale = 1.0F / length;
  return {along.y * scale, -along.x * scale, 0.0F};
}

}  // namespace

Frustum::Frustum(const SnowView& view)
    : eye_m_(view.eye_m),
      axes_(view.eye_m, view.target_m),
      half_width_(half_width(view.field_of_view_deg)),
      half_height_(half_width_ * view.height_px / view.width_px),
      slant_width_(math::hypot(1.0, half_width_)),
      slant_height_(math::hypot(1.0, half_height_)),
      pixel_angle_(2.0 * half_width_ / view.width_px) {}

double Frustum::solid_angle_sr() const {
  return 4.0 * math::atan(half_width_ * half_height_ /
                          std::sqrt(1.0 + half_width_ * half_width_ + half_height_ * half_height_));
}

double Frustum::half_angle() const { return math::atan(math::hypot(half_width_, half_height_)); }

Facing facing(const glm::vec3& towards_eye) {
  const glm::vec3 right = level_across(-towards_eye);
  return {right, glm::cross(towards_eye, right)};
}

}  // namespace wold::snow
