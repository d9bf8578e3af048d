#pragma once

#include <glm/glm.hpp>

namespace wold {

/// A linear map as a rotation, a scale and another rotation: matrix = u * diag(scale) * transposed
/// v.
struct SingularValues {
  glm::dmat3 u{1.0};
  glm::dvec3 scale{1.0};
  glm::dmat3 v{1.0};
};

/// Splits a matrix whose determinant is positive into proper rotations and positive scales
/// (two-sided Jacobi singular value decomposition, Imath).
SingularValues singular_values(const glm::dmat3& matrix);

}  // namespace wold
