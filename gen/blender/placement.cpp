#include "blender/placement.h"

#include <cmath>

#include "core/elementary.h"
#include "core/singular_values.h"

namespace wold::blender {
namespace {

/// x, y, z with rotation = Rz Ry Rx.
glm::dvec3 turn_of(const glm::dmat3& rotation) {
  const double about_z = math::atan2(rotation[0][1], rotation[0][0]);
  const double about_y = math::atan2(-rotation[0][2], std::sqrt(rotation[1][2] * rotation[1][2] +
                                                                rotation[2][2] * rotation[2][2]));
  // Turned back about z, so that it is exact where y is a right angle too.
  const double sine = math::sin(about_z);
  const double cosine = math::cos(about_z);
  const double about_x = math::atan2(sine * rotation[2][0] - cosine * rotation[2][1],
                                     cosine * rotation[1][1] - sine * rotation[1][0]);
  return {about_x, about_y, about_z};
}

}  // namespace

Placement placement_of(const glm::dmat4& world_from_cell) {
  const SingularValues parts = singular_values(glm::dmat3(world_from_cell));
  return {glm::dvec3(world_from_cell[3]), turn_of(glm::transpose(parts.v)), parts.scale,
          turn_of(parts.u)};
}

}  // namespace wold::blender
