#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "landscape/box_tree.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// Finds where rays meet what stands out of the terrain.
class RaisedCast {
 public:
  /// `raised` has to outlive it.
  explicit RaisedCast(const RaisedGround& raised);

  /// Distance in metres along a unit direction, at most `end_m`; that where the ray meets nothing
  /// before.
  double distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction, double end_m) const;

  /// Unit normal of the triangle at a place in world space, or less than a centimetre above or
  /// below it; none where there is none.
  std::optional<glm::dvec3> normal(const glm::dvec3& at_m) const;

 private:
  struct Hit {
    double distance_m;
    std::optional<std::uint32_t> triangle;
  };
  Hit first(const glm::dvec3& start_m, const glm::dvec3& direction, double end_m) const;
  /// From the origin of what is raised.
  std::array<glm::vec3, 3> corners(std::uint32_t triangle) const;

  const RaisedGround& raised_;
  BoxTree triangles_;
};

}  // namespace wold::landscape
