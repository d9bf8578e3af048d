#include "snow/snow_view.h"

#include <cmath>

#include "core/elementary.h"

namespace wold::snow {
namespace {

/// Level, to the right of `along`; east where that is vertical.
template <class Vector>
Vector level_across(const Vector& along) {
  using Number = typename Vector::value_type;
  const Number length = std::sqrt(along.x * along.x + along.y * along.y);
  if (!(length > Number(1e-6))) return {Number(1), Number(0), Number(0)};
  const Number scale = Number(1) / length;
  return {along.y * scale, -along.x * scale, Number(0)};
}

}  // namespace

Frustum::Frustum(const SnowView& view)
    : eye_m_(view.eye_m),
      ahead_(glm::normalize(view.target_m - view.eye_m)),
      right_(level_across(ahead_)),
      up_(glm::cross(right_, ahead_)),
      half_width_(math::tan(0.5 * glm::radians(view.field_of_view_deg))),
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
