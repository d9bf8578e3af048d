#include "core/pinhole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/interpolation.h"
#include "core/statistics.h"

namespace wold {
namespace {

void expect_axes(const CameraAxes& axes, const glm::dvec3& right, const glm::dvec3& up) {
  EXPECT_LT(glm::distance(axes.right, right), 1e-12);
  EXPECT_LT(glm::distance(axes.up, up), 1e-12);
}

TEST(CameraAxes, HaveTheEastOnTheRightOfTheNorth) {
  expect_axes({{1.0, 2.0, 3.0}, {1.0, 9.0, 3.0}}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
}

TEST(CameraAxes, HaveALevelRightWhereTheyLookDown) {
  const double half = std::sqrt(0.5);
  expect_axes({{0.0, 0.0, 5.0}, {5.0, 0.0, 0.0}}, {0.0, -1.0, 0.0}, {half, 0.0, half});
}

TEST(CameraAxes, HaveTheEastOnTheRightStraightDown) {
  expect_axes({{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
}

TEST(Pinhole, SeesAsFarToEachSideAsAheadAtARightAngle) {
  EXPECT_NEAR(half_width(90.0), 1.0, 1e-15);
  EXPECT_NEAR(pixels_per_radian(90.0, 600), 300.0, 1e-12);
}

TEST(Bilinear, HasTheCornersAndTheMiddle) {
  EXPECT_EQ(bilinear(1.0, 2.0, 3.0, 8.0, 0.0, 0.0), 1.0);
  EXPECT_EQ(bilinear(1.0, 2.0, 3.0, 8.0, 1.0, 0.0), 2.0);
  EXPECT_EQ(bilinear(1.0, 2.0, 3.0, 8.0, 0.0, 1.0), 3.0);
  EXPECT_EQ(bilinear(1.0, 2.0, 3.0, 8.0, 1.0, 1.0), 8.0);
  EXPECT_EQ(bilinear(1.0, 2.0, 3.0, 8.0, 0.5, 0.5), 3.5);
}

TEST(Mean, IsInDoublePrecisionAndZeroOfNone) {
  EXPECT_EQ(mean(std::vector<float>{}), 0.0);
  EXPECT_EQ(mean(std::vector<float>{16777216.0F, 1.0F, 1.0F, 0.0F}), 4194304.5);
}

}  // namespace
}  // namespace wold
