#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace wold::passes {

/// What the middle of a pixel shows.
struct SeenPlace {
  enum class Thing { nothing, ground, volume, blade };

  Thing thing = Thing::nothing;
  double distance_m = std::numeric_limits<double>::infinity();  ///< along the ray
  glm::dvec3 at_m{0.0};                                         ///< world space
  int cell = 0;                  ///< index into Landscape::cells, of a blade into blade_cells
  std::size_t ring = 0;          ///< of a blade, see BladeHit
  glm::vec3 blade_normal{0.0F};  ///< of a blade

  bool is_any() const { return thing != Thing::nothing; }
};

}  // namespace wold::passes
