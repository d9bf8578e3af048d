#pragma once

#include <glm/glm.hpp>

namespace wold::sky {

/// What a line of sight meets of one layer of clouds.
struct SeenClouds {
  float through = 1.0F;     ///< fraction of the light behind that comes through
  glm::vec3 sent{0.0F};     ///< radiance of the clouds
  double distance_m = 0.0;  ///< to them; 0 where there are none
};

}  // namespace wold::sky
