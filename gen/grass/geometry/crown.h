#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace wold::grass {

/// Where the twigs of a shrub end on a patch: on cushions, round and of different heights, as
/// junipers, heath and thorn scrub are seen from outside. They lie within the patch, so that shrubs
/// end where their neighbours are of grass. Leaves live where light is: most twigs end next to a
/// cushion's surface, none in its inner third (modelling choices).
class Crown {
 public:
  /// The end of a twig.
  struct Twig {
    glm::vec2 place_m;   ///< on the patch
    float height_m;      ///< over the ground, up to the crown's
    glm::vec3 outwards;  ///< unit; never downwards
  };

  /// Cushions up to `crown_m` high, as many as cover two and a half patches; keyed by
  /// (seed, variant). Both lengths are positive.
  Crown(double crown_m, double patch_m, std::uint64_t seed, int variant);

  /// The twig that four numbers from 0 to 1 pick, uniform ones as even as the cushions' surface.
  Twig twig(const glm::dvec4& picks) const;

 private:
  /// The upper half of an ellipsoid of revolution, on the ground.
  struct Cushion {
    glm::dvec2 middle_m;
    double radius_m;
    double height_m;
  };

  std::vector<Cushion> cushions_;
};

}  // namespace wold::grass
