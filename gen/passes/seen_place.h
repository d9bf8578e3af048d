#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace wold::passes {

/// What the middle of a pixel shows.
struct SeenPlace {
  static constexpr int ground = -1;

  double distance_m = std::numeric_limits<double>::infinity();  ///< along the ray
  glm::dvec3 at_m{0.0};                                         ///< world space
  int cell = ground;  ///< index into Landscape::cells, or the ground

  bool is_any() const { return std::isfinite(distance_m); }
};

}  // namespace wold::passes
