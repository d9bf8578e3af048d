#pragma once

#include <glm/glm.hpp>

namespace wold::blender {

/// A cell's matrix as Blender's geometry nodes can make it. Their instances take rotations and
/// scales about the point, but no shear, so the linear part is split by its singular values:
/// turn by V^T, scale by S, turn by U, then move. Angles are radians in Blender's XYZ order: x
/// first, then y, then z, about fixed axes.
struct Placement {
  glm::dvec3 position_m;
  glm::dvec3 first_turn_rad;   ///< V^T
  glm::dvec3 scale;            ///< S
  glm::dvec3 second_turn_rad;  ///< U
};

/// Splits world_from_cell, whose determinant is positive (core/singular_values.h).
Placement placement_of(const glm::dmat4& world_from_cell);

}  // namespace wold::blender
