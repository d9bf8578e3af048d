#include "grass/blade.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_meadow.h"

namespace wold::grass {
namespace {

using test::degree;

BladePose drooping(float droop) {
  BladePose pose;
  pose.droop = droop;
  return pose;
}

Blade leaning(double lean_deg) {
  Blade blade = test::straight_blade();
  blade.lean = static_cast<float>(lean_deg * degree);
  blade.length_m = 0.3F;
  return blade;
}

double polyline_m(const Blade& blade, const BladePose& pose) {
  constexpr int pieces = 1000;
  double length = 0.0;
  glm::dvec2 from(0.0);
  for (int i = 1; i <= pieces; ++i) {
    const float arc = blade.length_m * static_cast<float>(i) / pieces;
    const glm::dvec2 to(axis_point(blade, pose, arc).position_m);
    length += glm::distance(from, to);
    from = to;
  }
  return length;
}

// Paper 1, section 3.1: v = omega sqrt(h) l, so on a straight blade v ~ h^1.5.
TEST(Blade, DroopStartsWithThePapersSpeeds) {
  const Blade blade = leaning(0.0);
  const float droop = 0.02F;
  const auto speed = [&](float arc) {
    const glm::dvec2 moved = axis_point(blade, drooping(droop), arc).position_m -
                             axis_point(blade, drooping(0.0F), arc).position_m;
    return glm::length(moved) / double{droop};
  };
  EXPECT_NEAR(speed(0.1F), std::pow(0.1, 1.5), 1e-3 * std::pow(0.1, 1.5));
  EXPECT_NEAR(speed(0.2F) / speed(0.1F), std::pow(2.0, 1.5), 5e-3);
}

TEST(Blade, KeepsItsLengthHoweverFarItDroops) {
  for (double lean_deg : {0.0, 14.0, 70.0})
    for (float droop : {0.0F, 0.01F, 0.5F, 1.0F, 3.0F, 8.0F}) {
      const Blade blade = leaning(lean_deg);
      EXPECT_NEAR(polyline_m(blade, drooping(droop)) / double{blade.length_m}, 1.0, 1e-3)
          << "lean " << lean_deg << ", droop " << droop;
    }
}

TEST(Blade, TipTurnsMoreThanBaseAndNothingSinksIntoTheGround) {
  const Blade blade = leaning(10.0);
  for (float droop : {0.3F, 2.0F, 6.0F}) {
    double angle = double{blade.lean};
    for (int i = 1; i <= 50; ++i) {
      const AxisPoint at =
          axis_point(blade, drooping(droop), blade.length_m * static_cast<float>(i) / 50.0F);
      const double now = std::atan2(double{at.position_m.x}, double{at.position_m.y});
      EXPECT_GE(at.position_m.y, 0.0F);
      EXPECT_LE(now, 90.0 * degree + 1e-6);
      if (at.position_m.y > 0.0F) {
        EXPECT_GT(now, angle);
      }
      EXPECT_NEAR(glm::length(at.tangent), 1.0F, 1e-6);
      angle = now;
    }
  }
}

TEST(Blade, TangentIsTheDirectionOfTheAxis) {
  const Blade blade = leaning(14.0);
  for (float arc : {0.05F, 0.15F, 0.25F}) {
    constexpr float step = 1e-3F;
    const BladePose pose = drooping(1.5F);
    const glm::vec2 along = glm::normalize(axis_point(blade, pose, arc + step).position_m -
                                           axis_point(blade, pose, arc - step).position_m);
    EXPECT_GT(glm::dot(along, axis_point(blade, pose, arc).tangent), 1.0F - 1e-5F);
  }
}

TEST(ScatterBlades, DrawsTheSceneDistributionsOnePerCell) {
  scene::Grass grass;
  grass.blades = 2500;  // 50 x 50 cells
  const auto blades = scatter_blades(grass, {}, 3, 1);
  ASSERT_EQ(blades.size(), 2500U);
  std::vector<int> taken(2500, 0);
  double length = 0.0;
  for (const Blade& blade : blades) {
    const glm::ivec2 cell(blade.root_m * static_cast<float>(50.0 / grass.patch_m));
    ++taken[static_cast<std::size_t>(cell.y * 50 + cell.x)];
    length += double{blade.length_m} / 2500.0;
  }
  EXPECT_EQ(std::count(taken.begin(), taken.end(), 1), 2500);
  // Standard error of the mean: 0.25 / sqrt(2500) = 0.5 %.
  EXPECT_NEAR(length / grass.height_m, 1.0, 0.02);
}

TEST(ScatterBlades, VariantsDiffer) {
  const scene::Grass grass;
  const auto a = scatter_blades(grass, {}, 3, 0);
  const auto b = scatter_blades(grass, {}, 3, 1);
  int same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) same += a[i].length_m == b[i].length_m ? 1 : 0;
  EXPECT_LE(same, 40);  // both ends of the length's range are cut
}

}  // namespace
}  // namespace wold::grass
