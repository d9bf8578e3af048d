#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace wold {

/// Where on the straight way from `begin` to `end` the place nearest to `at` lies, as a share of
/// the way, in [0, 1]; 0 where the way has no length. All in the same unit.
inline double share_of_way(const glm::dvec2& at, const glm::dvec2& begin, const glm::dvec2& end) {
  const glm::dvec2 along = end - begin;
  const double length2 = glm::dot(along, along);
  return length2 > 0.0 ? std::clamp(glm::dot(at - begin, along) / length2, 0.0, 1.0) : 0.0;
}

}  // namespace wold
