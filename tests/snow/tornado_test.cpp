#include "snow/tornado.h"

#include <gtest/gtest.h>

#include <cmath>

#include "snow/seen_flakes.h"

namespace wold::snow {
namespace {

Tornado tornado() {
  scene::Scene scene;
  scene.terrain.size_m = 50.0;  // the funnel is 30 m high
  return Tornado(scene, 1, 4000);
}

double axis_distance(const Tornado& whirl, const Flake& flake, double time_s) {
  return glm::distance(glm::dvec2(flake.centre_m), whirl.foot_m(time_s));
}

TEST(Tornado, StandsInTheMiddleAndWidensUpwards) {
  const Tornado whirl = tornado();
  EXPECT_NEAR(glm::distance(whirl.foot_m(0.0), {25.0, 25.0}), 0.0, 1e-9);
  double low = 0.0, high = 0.0;
  int low_count = 0, high_count = 0;
  for (std::uint64_t i = 0; i < whirl.flakes(); ++i) {
    const Flake flake = whirl.flake(i, 30.0, 10.0);
    ASSERT_GE(flake.centre_m.z, 10.0);
    ASSERT_LE(flake.centre_m.z, 40.0);
    const double distance_m = axis_distance(whirl, flake, 30.0);
    if (flake.centre_m.z > 15.0 && flake.centre_m.z < 20.0) low += distance_m, ++low_count;
    if (flake.centre_m.z > 33.0 && flake.centre_m.z < 36.0) high += distance_m, ++high_count;
  }
  ASSERT_GT(low_count, 200);
  ASSERT_GT(high_count, 200);
  EXPECT_GT(high / high_count, 2.0 * low / low_count);
}

/// All turn the same way, and places move at their velocities: the angle is the integral of the
/// angular speed.
TEST(Tornado, FlakesMoveOnHelicesAtTheirVelocities) {
  const Tornado whirl = tornado();
  const double step_s = 1e-4;
  int compared = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Flake before = whirl.flake(i, 10.0 - step_s, 0.0);
    const Flake after = whirl.flake(i, 10.0 + step_s, 0.0);
    const glm::dvec3 velocity = (after.centre_m - before.centre_m) / (2.0 * step_s);
    if (std::abs(velocity.z) > 30.0) continue;  // from the top to the foot
    const Flake now = whirl.flake(i, 10.0, 0.0);
    const glm::dvec2 out = glm::dvec2(now.centre_m) - whirl.foot_m(10.0);
    // The axis's own bending and wandering are not in the velocity.
    EXPECT_NEAR(glm::distance(velocity, now.velocity_m_s), 0.0, 4.5) << i;
    if (now.centre_m.z > 3.0 && now.centre_m.z < 8.0) {
      EXPECT_GT(out.x * now.velocity_m_s.y - out.y * now.velocity_m_s.x, 0.0) << i;
      EXPECT_GT(now.velocity_m_s.z, 0.0) << i;
    }
    ++compared;
  }
  EXPECT_GT(compared, 480);
}

/// What rises keeps its fraction of a radius that grows twelvefold over the height: it goes
/// outwards by r log(12) / H for each metre. The axis bends, which counts for nothing on the mean.
TEST(Tornado, FlakesGoOutwardsAsItWidens) {
  const Tornado whirl = tornado();
  double out_m_s = 0.0, expected_m_s = 0.0;
  int count = 0;
  for (std::uint64_t i = 0; i < whirl.flakes(); ++i) {
    const Flake flake = whirl.flake(i, 30.0, 0.0);
    if (flake.centre_m.z < 4.0 || flake.centre_m.z > 9.0) continue;  // nor about the foot
    const glm::dvec2 from_axis_m = glm::dvec2(flake.centre_m) - whirl.foot_m(30.0);
    out_m_s += glm::dot(glm::dvec2(flake.velocity_m_s), glm::normalize(from_axis_m));
    expected_m_s += glm::length(from_axis_m) * std::log(12.0) / 30.0 * flake.velocity_m_s.z;
    ++count;
  }
  ASSERT_GT(count, 300);
  EXPECT_GT(expected_m_s / count, 0.15);
  EXPECT_NEAR(out_m_s / count, expected_m_s / count, 0.4 * expected_m_s / count);
}

/// As the paper's flakes do: about the way to the eye and to either side of facing it.
TEST(Tornado, FlakesTurn) {
  const Tornado whirl = tornado();
  const double step_s = 0.01;
  double spun = 0.0, tilted = 0.0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Flake before = whirl.flake(i, 10.0, 0.0), after = whirl.flake(i, 10.0 + step_s, 0.0);
    spun += std::abs(std::remainder(after.spin_turns - before.spin_turns, 1.0F));
    tilted += std::abs(std::remainder(after.tilt_turns - before.tilt_turns, 1.0F));
  }
  EXPECT_NEAR(spun / 500.0 / step_s, 0.625, 0.06);  // evenly spread up to 1.25 turns a second
  EXPECT_NEAR(tilted / 500.0 / step_s, 1.5, 0.1);   // from 0.5 to 2.5
}

}  // namespace
}  // namespace wold::snow
