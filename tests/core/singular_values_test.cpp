#include "core/singular_values.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace wold {
namespace {

/// A shear, a mirror, a stretched turn, and a matrix of rank 1.
const std::array<glm::dmat3, 4> matrices = {{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.4, -0.7, 1.0}},
                                             {{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                                             {{0.0, 2.0, 0.0}, {-3.0, 0.0, 0.0}, {0.0, 0.0, 0.5}},
                                             {{1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}, {3.0, 6.0, 9.0}}}};

void expect_near(const glm::dmat3& got, const glm::dmat3& want) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) EXPECT_NEAR(got[column][row], want[column][row], 1e-12);
}

TEST(SingularValues, MakeTheMatrixAgain) {
  for (const glm::dmat3& matrix : matrices) {
    const SingularValues parts = singular_values(matrix);
    const glm::dmat3 scale(glm::dvec3(parts.scale.x, 0.0, 0.0), glm::dvec3(0.0, parts.scale.y, 0.0),
                           glm::dvec3(0.0, 0.0, parts.scale.z));
    expect_near(parts.u * scale * glm::transpose(parts.v), matrix);
  }
}

TEST(SingularValues, TurnWithoutMirroring) {
  for (const glm::dmat3& matrix : matrices) {
    const SingularValues parts = singular_values(matrix);
    for (const glm::dmat3& turn : {parts.u, parts.v}) {
      expect_near(turn * glm::transpose(turn), glm::dmat3(1.0));
      EXPECT_NEAR(glm::determinant(turn), 1.0, 1e-12);
    }
  }
}

// Of a shear by s of height: the square root of 1 + s^2 / 2 -+ s sqrt(1 + s^2 / 4), and 1.
TEST(SingularValues, OfAShearAreThoseOfItsClosedForm) {
  const double s = 0.8;
  const glm::dmat3 shear({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {s, 0.0, 1.0});
  const glm::dvec3 scale = singular_values(shear).scale;
  const double spread = s * std::sqrt(1.0 + s * s / 4.0);
  EXPECT_NEAR(scale.x, std::sqrt(1.0 + s * s / 2.0 + spread), 1e-12);
  EXPECT_NEAR(scale.y, 1.0, 1e-12);
  EXPECT_NEAR(scale.z, std::sqrt(1.0 + s * s / 2.0 - spread), 1e-12);
}

}  // namespace
}  // namespace wold
