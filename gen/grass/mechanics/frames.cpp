#include "grass/mechanics/frames.h"

#include <cmath>

namespace wold::grass {
namespace {

constexpr float min_rise = 0.0175F;  // sine of 1 degree
constexpr float min_way_m = 1e-5F;

/// `vector` turned by the least rotation that takes the unit vector `from` to `to` (Rodrigues).
glm::vec3 turned(const glm::vec3& vector, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 axis = glm::cross(from, to);
  const float cosine = glm::dot(from, to);
  if (cosine < -0.9999F) return vector;  // turned right over: any axis would do
  return cosine * vector + glm::cross(axis, vector) +
         glm::dot(axis, vector) / (1.0F + cosine) * axis;
}

}  // namespace

PointFrame moved_frame(const PointFrame& before, const glm::vec3& position_m) {
  PointFrame after{position_m, before.tangent, before.normal};
  const glm::vec3& t = before.tangent;
  if (std::abs(t.z) < min_rise) return after;
  const glm::vec3 foot_m = before.position_m - before.position_m.z / t.z * t;
  const glm::vec3 way_m = position_m - foot_m;
  const float length_m = glm::length(way_m);
  if (length_m < min_way_m || position_m.z < min_way_m) return after;
  after.tangent = way_m / length_m;
  if (before.normal == glm::vec3(0.0F)) return after;
  const glm::vec3 normal = turned(before.normal, t, after.tangent);
  after.normal = glm::normalize(normal - glm::dot(normal, after.tangent) * after.tangent);
  return after;
}

}  // namespace wold::grass
