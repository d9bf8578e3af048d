#pragma once

#include "core/ground_map.h"
#include "light/daylight.h"
#include "meadow/far_field.h"
#include "place/view.h"

namespace wold::ground {

/// The air between the eye and the ground, by Koschmieder: it hides and it glows.
class Haze {
 public:
  /// `day` has to outlive it.
  Haze(const light::Daylight& day, const glm::dvec3& eye_m);

  /// A radiance as it is seen from the eye, at a place.
  glm::vec3 before(const glm::vec3& radiance, const glm::dvec3& at_m) const;

 private:
  const light::Daylight& day_;
  glm::dvec3 eye_m_;
};

/// Whether any of the terrain is so far from the eye that haze is seen there: 2 % of it.
bool shows_haze(const Heightfield& terrain, const glm::dvec3& eye_m, double visual_range_m);

/// Puts the haze before the ground.
void veil_ground(ColourMap& ground, const Heightfield& terrain, const place::View& view,
                 const Haze& haze);

/// Puts the haze before the grass that stands: a factor on its light that makes `meadow` look as
/// it would behind the haze. `light` is without tints.
ColourMap veil_of_grass(const ColourMap& light, const Heightfield& terrain, const place::View& view,
                        const meadow::Meadow& meadow, const Haze& haze);

}  // namespace wold::ground
