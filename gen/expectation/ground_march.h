#pragma once

#include <glm/glm.hpp>
#include <utility>

#include "core/ground_map.h"

namespace wold::expectation {

/// Finds where rays meet the terrain: it marches along them until they are below it.
class GroundMarch {
 public:
  /// `terrain` has to outlive it.
  explicit GroundMarch(const Heightfield& terrain);

  /// Distance in metres along a unit direction to the ground; infinite where the ray meets none.
  /// The ray is known to be above the ground up to `above_to_m`. Ground is taken as 60 degrees
  /// steep at most, and what is narrower than a third of the terrain's step can be missed.
  double distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction,
                    double above_to_m = 0.0) const;

 private:
  std::pair<double, double> inside_m(const glm::dvec3& eye_m, const glm::dvec3& direction) const;
  double gap_m(const glm::dvec3& at_m) const;

  const Heightfield& terrain_;
  double steepest_;
  glm::dvec3 low_;
  glm::dvec3 high_;
};

}  // namespace wold::expectation
