#pragma once

#include <array>
#include <glm/glm.hpp>
#include <limits>

namespace wold::landscape {

/// Where the ray start + m * along meets a triangle, as m > 0 [Moeller1997]; infinite beside it.
inline double meeting_m(const glm::dvec3& start, const glm::dvec3& along,
                        const std::array<glm::vec3, 3>& corners) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const glm::dvec3 first(corners[0]);
  const glm::dvec3 one = glm::dvec3(corners[1]) - first, other = glm::dvec3(corners[2]) - first;
  const glm::dvec3 across = glm::cross(along, other);
  const double volume = glm::dot(one, across);
  if (volume == 0.0) return infinite;
  const glm::dvec3 away = start - first;
  const double u = glm::dot(away, across) / volume;
  const glm::dvec3 turned = glm::cross(away, one);
  const double v = glm::dot(along, turned) / volume;
  const double at_m = glm::dot(other, turned) / volume;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && at_m > 0.0 ? at_m : infinite;
}

/// Across a triangle, of no unit length; counter-clockwise corners are seen from where it points.
inline glm::dvec3 across(const std::array<glm::vec3, 3>& corners) {
  return glm::cross(glm::dvec3(corners[1]) - glm::dvec3(corners[0]),
                    glm::dvec3(corners[2]) - glm::dvec3(corners[0]));
}

}  // namespace wold::landscape
