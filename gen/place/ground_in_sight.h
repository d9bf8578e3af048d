#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"

namespace wold::place {

/// What an eye sees of a terrain's ground, as renderers have it: the rest lies behind nearer
/// ground. Along 4096 ways from the eye it knows how high the ground before each distance looks.
class GroundInSight {
 public:
  /// The terrain has to outlive it. The eye may stand outside of it.
  GroundInSight(const Heightfield& terrain, const glm::dvec3& eye_m);

  /// Whether ground at a place of the terrain, or anything that is at most `margin_m` >= 0 from it,
  /// can be seen. May say yes where it cannot, since crests are looked at in steps of 1.6 % of the
  /// distance; and no where it can through a notch in a crest that is narrower than two ways, some
  /// 3 mrad.
  bool may_see(const glm::dvec2& at_m, double margin_m) const;

 private:
  float& highest(std::size_t way, std::size_t ring) { return highest_[way * rings_ + ring]; }
  float highest(std::size_t way, std::size_t ring) const { return highest_[way * rings_ + ring]; }
  void look_along(std::size_t way);

  const Heightfield& terrain_;
  glm::dvec3 eye_m_;
  std::size_t rings_;
  std::vector<float> highest_;  ///< tangent over level of the ground up to a ring, by way
};

}  // namespace wold::place
