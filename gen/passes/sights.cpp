#include "passes/sights.h"

#include <algorithm>
#include <cmath>

namespace wold::passes {

bool Sight::meets_blade() const { return std::isfinite(blade.distance_m); }

bool Sight::meets_ground() const { return !meets_blade() && std::isfinite(ground_m); }

SeenPlace Sight::seen(const glm::dvec3& eye_m, const glm::dvec3& direction) const {
  using Thing = SeenPlace::Thing;
  SeenPlace seen;
  if (std::isfinite(grass.half_m))
    seen = {Thing::volume, grass.half_m, {}, grass.half_cell};
  else if (meets_blade())
    seen = {Thing::blade, blade.distance_m, {}, blade.cell, blade.ring, glm::vec3(blade.normal)};
  else if (meets_ground())
    seen = {Thing::ground, ground_m};
  if (seen.is_any()) seen.at_m = eye_m + seen.distance_m * direction;
  return seen;
}

Sights::Sights(const landscape::Landscape& landscape)
    : eye_m_(landscape.camera.eye_m),
      ground_(landscape.terrain),
      raised_(landscape.boulders),
      grass_(landscape),
      blades_(landscape) {}

glm::dvec3 Sights::ground_normal(const glm::dvec3& at_m) const {
  const std::optional<glm::dvec3> raised = raised_.normal(at_m);
  return raised ? *raised : ground_.normal(glm::dvec2(at_m));
}

void Sights::look(const glm::dvec3& direction, Sight& sight) const {
  sight.ground_m = raised_.distance_m(eye_m_, direction, ground_.distance_m(eye_m_, direction));
  sight.blade = blades_.look(eye_m_, direction, sight.ground_m);
  grass_.look(eye_m_, direction, std::min(sight.ground_m, sight.blade.distance_m), sight.grass);
}

}  // namespace wold::passes
