#pragma once

#include <glm/glm.hpp>

namespace wold::usd {

/// A cell's matrix as two transforms, one inside the other, neither of which shears: hosts that
/// keep a place, a turn and a scale for each object lose a shear.
struct Placement {
  glm::dmat4 outer{1.0};  ///< scales along the cell's own axes, turns, and moves
  glm::dmat4 inner{1.0};  ///< turns
};

/// outer * inner is the matrix, whose determinant is positive.
Placement placement_of(const glm::dmat4& world_from_cell);

}  // namespace wold::usd
