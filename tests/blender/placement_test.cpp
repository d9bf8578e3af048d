#define GLM_ENABLE_EXPERIMENTAL
#include "blender/placement.h"

#include <gtest/gtest.h>

#include <glm/gtx/euler_angles.hpp>
#include <numbers>

namespace wold::blender {
namespace {

/// What Blender makes of angles in its XYZ order: x first.
glm::dmat3 rotation(const glm::dvec3& turn_rad) {
  return glm::dmat3(glm::eulerAngleZYX(turn_rad.z, turn_rad.y, turn_rad.x));
}

glm::dmat3 linear_part(const Placement& placement) {
  glm::dmat3 scale(0.0);
  for (int axis = 0; axis < 3; ++axis) scale[axis][axis] = placement.scale[axis];
  return rotation(placement.second_turn_rad) * scale * rotation(placement.first_turn_rad);
}

double largest_difference(const glm::dmat3& a, const glm::dmat3& b) {
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
  return largest;
}

/// A cell on a slope: quarter-turns, then z += dx x + dy y.
glm::dmat4 cell(int quarters, double dx, double dy) {
  const glm::dmat4 turn = glm::eulerAngleZ(quarters * std::numbers::pi / 2.0);
  const glm::dmat4 shear({1, 0, dx, 0}, {0, 1, dy, 0}, {0, 0, 1, 0}, {3.0, -2.0, 0.5, 1});
  return shear * turn;
}

// Turning, scaling and turning again is the matrix it was made from, flat ground and cliffs alike.
TEST(Placement, RebuildsTheMatrix) {
  for (int quarters = 0; quarters < 4; ++quarters)
    for (const double dx : {0.0, 1e-9, -0.3, 2.0})
      for (const double dy : {0.0, 0.15, -2.0}) {
        const glm::dmat4 wanted = cell(quarters, dx, dy);
        const Placement placement = placement_of(wanted);
        EXPECT_LT(largest_difference(linear_part(placement), glm::dmat3(wanted)), 1e-6)
            << quarters << " quarter-turns, slope " << dx << ", " << dy;
        EXPECT_EQ(placement.position_m, glm::dvec3(3.0, -2.0, 0.5));
      }
}

// Singular values of a shear z += s x are (sqrt(4 + s^2) +- s) / 2 and 1; all positive: nothing is
// mirrored.
TEST(Placement, ScalesAreTheSingularValuesOfTheShear) {
  const double s = 0.8;
  const glm::dvec3 scale = placement_of(cell(0, s, 0.0)).scale;
  EXPECT_NEAR(scale.x, (std::sqrt(4.0 + s * s) + s) / 2.0, 1e-12);
  EXPECT_NEAR(scale.y, 1.0, 1e-12);
  EXPECT_NEAR(scale.z, (std::sqrt(4.0 + s * s) - s) / 2.0, 1e-12);
}

}  // namespace
}  // namespace wold::blender
