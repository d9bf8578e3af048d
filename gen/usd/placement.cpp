#include "usd/placement.h"

#include "core/singular_values.h"

namespace wold::usd {

Placement placement_of(const glm::dmat4& world_from_cell) {
  const SingularValues parts = singular_values(glm::dmat3(world_from_cell));
  Placement placement;
  for (int axis = 0; axis < 3; ++axis)
    placement.outer[axis] = glm::dvec4(parts.u[axis] * parts.scale[axis], 0.0);
  placement.outer[3] = world_from_cell[3];
  placement.inner = glm::dmat4(glm::transpose(parts.v));
  return placement;
}

}  // namespace wold::usd
