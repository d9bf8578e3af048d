#pragma once

#include <glm/glm.hpp>

namespace wold::terrain {

/// What feet have made of a place.
struct Trodden {
  double bare = 0.0;         ///< share of a piece of ground, a step wide, that is worn, in [0, 1]
  double level = 0.0;        ///< how far what stood out there is gone, in [0, 1]
  glm::dvec2 gradient{0.0};  ///< steepest ascent of what they have worn off and levelled
};

}  // namespace wold::terrain
