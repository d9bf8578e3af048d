#include "blender/placement.h"

#include <Imath/ImathMatrixAlgo.h>

#include <cmath>

#include "core/elementary.h"

namespace wold::blender {
namespace {

using Rows = Imath::M33d;  // indexed [row][column], as mathematics writes it

Rows rows_of(const glm::dmat4& matrix) {
  Rows rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) rows[row][column] = matrix[column][row];
  return rows;
}

glm::dmat3 columns_of(const Rows& rows) {
  glm::dmat3 matrix;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) matrix[column][row] = rows[row][column];
  return matrix;
}

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
  Rows u_rows;
  Rows v_rows;
  Imath::V3d scale;
  constexpr bool without_mirroring = true;
  Imath::jacobiSVD(rows_of(world_from_cell), u_rows, scale, v_rows, 1e-15, without_mirroring);
  return {glm::dvec3(world_from_cell[3]),
          turn_of(glm::transpose(columns_of(v_rows))),
          {scale.x, scale.y, scale.z},
          turn_of(columns_of(u_rows))};
}

}  // namespace wold::blender
