#include "grass/mechanics/frames.h"

#include <gtest/gtest.h>

#include "small_meadow.h"

namespace wold::grass {
namespace {

/// The unit tangent of figure 6a, written out.
glm::vec3 figure_6a(const PointFrame& at, const glm::vec3& moved_m) {
  const glm::vec3 &s = at.position_m, &t = at.tangent;
  return glm::normalize(glm::vec3(moved_m.x - (s.x - s.z / t.z * t.x),
                                  moved_m.y - (s.y - s.z / t.z * t.y), moved_m.z));
}

TEST(Frames, TangentsPointFromTheFootByFigure6a) {
  const glm::vec3 foot_m(0.1F, 0.2F, 0.0F);
  PointFrame frame;
  frame.tangent = glm::normalize(glm::vec3(0.2F, 0.1F, 0.9F));
  frame.position_m = foot_m + 0.2F * frame.tangent;
  frame.normal = glm::normalize(glm::cross(frame.tangent, glm::vec3(0.0F, 1.0F, 0.0F)));
  for (int step = 0; step < 40; ++step) {
    // Turns about the foot and sinks.
    const glm::vec3 moved_m = frame.position_m + glm::vec3(0.003F, 0.001F, -0.004F);
    const glm::vec3 expected = figure_6a(frame, moved_m);
    frame = moved_frame(frame, moved_m);
    ASSERT_LT(glm::distance(frame.tangent, expected), 1e-5F);
    ASSERT_LT(glm::distance(frame.tangent, glm::normalize(moved_m - foot_m)), 1e-3F) << step;
    ASSERT_NEAR(glm::length(frame.tangent), 1.0F, 1e-5F);
    ASSERT_NEAR(glm::length(frame.normal), 1.0F, 1e-5F);
    ASSERT_NEAR(glm::dot(frame.tangent, frame.normal), 0.0F, 1e-5F);
  }
}

// The least rotation: a normal that stands on the plane of the motion stays, one within it turns.
TEST(Frames, NormalsTurnWithTheirTangents) {
  const PointFrame upright{{0.0F, 0.0F, 0.1F}, {0.0F, 0.0F, 1.0F}, {0.0F, 1.0F, 0.0F}};
  const glm::vec3 fallen_m(0.08F, 0.0F, 0.06F);
  EXPECT_LT(glm::distance(moved_frame(upright, fallen_m).normal, {0.0F, 1.0F, 0.0F}), 1e-6F);
  PointFrame within = upright;
  within.normal = {1.0F, 0.0F, 0.0F};
  EXPECT_LT(glm::distance(moved_frame(within, fallen_m).normal, {0.6F, 0.0F, -0.8F}), 1e-6F);
  within.normal = glm::vec3(0.0F);
  EXPECT_EQ(moved_frame(within, fallen_m).normal, glm::vec3(0.0F));  // vein tissue
}

TEST(Frames, LevelAndLyingPointsKeepTheirFrames) {
  const PointFrame level{{0.1F, 0.0F, 0.02F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}};
  EXPECT_EQ(moved_frame(level, {0.1F, 0.0F, 0.01F}).tangent, level.tangent);
  const PointFrame steep{{0.1F, 0.0F, 0.02F}, {0.0F, 0.0F, 1.0F}, {0.0F, 1.0F, 0.0F}};
  EXPECT_EQ(moved_frame(steep, {0.12F, 0.0F, 0.0F}).tangent, steep.tangent);
}

}  // namespace
}  // namespace wold::grass
