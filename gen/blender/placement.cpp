#define GLM_ENABLE_EXPERIMENTAL
#include "blender/placement.h"

#include <Imath/ImathMatrixAlgo.h>

#include <glm/gtx/euler_angles.hpp>

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
  glm::dvec3 turn_rad;
  glm::extractEulerAngleZYX(glm::dmat4(rotation), turn_rad.z, turn_rad.y, turn_rad.x);
  return turn_rad;
}

}  // namespace

Placement placement_of(const glm::dmat4& world_from_cell) {
  Rows u_rows;
  Rows v_rows;
  Imath::V3d scale;
  Imath::jacobiSVD(rows_of(world_from_cell), u_rows, scale, v_rows, 1e-15, true);
  glm::dmat3 u = columns_of(u_rows);
  glm::dmat3 v = columns_of(v_rows);
  if (glm::determinant(v) < 0.0) {  // then U mirrors too: turn both round, the product stays
    u[2] = -u[2];
    v[2] = -v[2];
  }
  return {glm::dvec3(world_from_cell[3]),
          turn_of(glm::transpose(v)),
          {scale.x, scale.y, scale.z},
          turn_of(u)};
}

}  // namespace wold::blender
