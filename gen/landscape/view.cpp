#include "landscape/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wold::landscape {

Camera resolved_camera(const scene::Camera& camera, const Heightfield& terrain) {
  const auto above_ground = [&](const std::array<double, 2>& at_m, double height_m) {
    return glm::dvec3(at_m[0], at_m[1], terrain.sample(at_m[0], at_m[1]) + height_m);
  };
  return {above_ground(camera.eye_m, camera.eye_height_m),
          above_ground(camera.target_m, camera.target_height_m), camera.field_of_view_deg};
}

View::View(const Camera& camera, int width_px, int height_px) : eye_m_(camera.eye_m) {
  const glm::dvec3 forward = glm::normalize(camera.target_m - camera.eye_m);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double across = std::tan(camera.field_of_view_deg * std::numbers::pi / 360.0);
  const double upwards = across * height_px / width_px;
  inwards_ = {glm::normalize(forward * across + right), glm::normalize(forward * across - right),
              glm::normalize(forward * upwards + up), glm::normalize(forward * upwards - up),
              forward};
  pixels_per_radian_ = width_px / (2.0 * across);
}

bool View::may_see(const glm::dvec3& centre_m, double radius_m) const {
  return std::all_of(inwards_.begin(), inwards_.end(), [&](const glm::dvec3& inwards) {
    return glm::dot(inwards, centre_m - eye_m_) >= -radius_m;
  });
}

double View::pixels(double length_m, const glm::dvec3& at_m) const {
  return pixels_per_radian_ * length_m / std::max(glm::length(at_m - eye_m_), 1e-6);
}

}  // namespace wold::landscape
