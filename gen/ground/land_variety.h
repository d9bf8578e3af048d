#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace wold::ground {

/// How places that lie alike differ: in which colours, and how many of them. Bushes are few and
/// dark, so most places are somewhat brighter than the mean.
///
/// Places are put in order along the main axis of their deviations: what a value of a normal
/// variable stands for is the place of the same rank.
class LandVariety {
 public:
  /// `deviations`: of places from the mean of what lies alike, over it; their own mean, which is
  /// about 0, does not count. None: all are the mean.
  explicit LandVariety(std::span<const glm::vec3> deviations);

  /// Mean deviation of places of which only a part of their normal variable is known: `known`, of
  /// variance `shown`, from 0 to 1. It counts from -3 to 3.
  glm::vec3 at(double known, double shown) const;

 private:
  std::vector<glm::vec3> table_;  ///< by the known part, row by row of what is shown
};

}  // namespace wold::ground
