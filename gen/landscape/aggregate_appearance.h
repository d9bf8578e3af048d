#pragma once

#include <glm/glm.hpp>

namespace wold::landscape {

/// What a meadow of one kind of patch shows from far away, where a pixel covers many blades.
struct AggregateAppearance {
  glm::dvec3 radiance{0.0};    ///< of the grass alone
  double transmittance = 1.0;  ///< fraction of the ground below that is seen
};

}  // namespace wold::landscape
