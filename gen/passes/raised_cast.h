#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "landscape/landscape.h"
#include "passes/box_tree.h"

namespace wold::passes {

/// Finds where rays meet what stands out of the terrain.
class RaisedCast {
 public:
  /// `raised` has to outlive it.
  explicit RaisedCast(const landscape::RaisedGround& raised);

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
  std::array<glm::vec3, 3> corners(std::uint32_t triangle) const;

  const landscape::RaisedGround& raised_;
  BoxTree triangles_;
};

}  // namespace wold::passes
