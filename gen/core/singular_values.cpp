#include "core/singular_values.h"

#include <Imath/ImathMatrixAlgo.h>

namespace wold {
namespace {

using Rows = Imath::M33d;  // indexed [row][column], as mathematics writes it

Rows rows_of(const glm::dmat3& matrix) {
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

}  // namespace

SingularValues singular_values(const glm::dmat3& matrix) {
  Rows u;
  Rows v;
  Imath::V3d scale;
  constexpr bool without_mirroring = true;
  Imath::jacobiSVD(rows_of(matrix), u, scale, v, 1e-15, without_mirroring);
  return {columns_of(u), {scale.x, scale.y, scale.z}, columns_of(v)};
}

}  // namespace wold
