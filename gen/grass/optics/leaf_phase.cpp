#include "grass/optics/leaf_phase.h"

#include <numbers>

namespace wold::grass {

glm::vec3 seen_along(const glm::vec3& tangent, const glm::vec3& direction) {
  const glm::vec3 across = direction - glm::dot(direction, tangent) * tangent;
  const float length = glm::length(across);
  return length > 1e-6F ? across / length : glm::vec3(0.0F);
}

LeafPhase leaf_phase(const glm::vec3& tangent, const glm::vec3& light, const glm::vec3& view) {
  constexpr float quarter_pi = std::numbers::pi_v<float> / 4.0F;
  const float cosine = glm::dot(seen_along(tangent, light), seen_along(tangent, view));
  const float square = cosine * cosine;
  // c asin(c) + sqrt(1 - c^2) as a series, whose last term makes it exact at 1: within 0.005.
  const float both = quarter_pi * (1.0F + square * (0.5F + 0.0708F * square));
  const float apart = 0.5F * std::numbers::pi_v<float> * quarter_pi * cosine;
  return {both + apart, both - apart};
}

}  // namespace wold::grass
