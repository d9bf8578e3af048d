#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace wold::grass {

/// Where the twigs of a shrub end on a patch: on cushions, round and of different heights, as
/// junipers, heath and thorn scrub are seen from outside. They lie within the patch, with
/// most of their leaves: a patch beside it may be of grass, and what stands out over the border is
/// cut off there. Leaves live where light is: most twigs end next to a cushion's surface, none in
/// its inner third (modelling choices).
class Crown {
 public:
  /// The upper half of an ellipsoid of revolution, on the ground.
  struct Cushion {
    glm::dvec2 middle_m;  ///< on the patch
    double radius_m;
    double height_m;
  };

  /// The end of a twig.
  struct Twig {
    glm::vec2 place_m;   ///< on the patch
    float height_m;      ///< over the ground, up to the crown's
    glm::vec3 outwards;  ///< unit; never downwards
    float inwards_m;     ///< how far it may reach back above the ground: half its cushion's radius
  };

  /// Lengths in metres, all positive.
  struct Size {
    double crown_m;  ///< height of the highest cushion
    double patch_m;  ///< side of the patch
    double leaf_m;   ///< how far leaves stand out over twigs; 0.3 patches at most are left for it
  };

  /// As many cushions as would cover two and a half times the part of the patch that leaves leave
  /// them; keyed by (seed, variant).
  Crown(const Size& size, std::uint64_t seed, int variant);

  /// The twig that four numbers from 0 to 1 pick, uniform ones as even as the cushions' surface.
  Twig twig(const glm::dvec4& picks) const;

  const std::vector<Cushion>& cushions() const { return cushions_; }

 private:
  std::vector<Cushion> cushions_;
};

/// That of a shrub's patch, with room for leaves as long as most are.
Crown crown_of(const scene::Plant& shrub, double patch_m, std::uint64_t seed, int variant);

}  // namespace wold::grass
