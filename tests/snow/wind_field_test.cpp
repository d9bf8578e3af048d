#include "snow/wind_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace wold::snow {
namespace {

Weather windy(double speed_m_s) {
  scene::Scene scene;
  scene.wind.speed_m_s = speed_m_s;
  scene.wind.heading_deg = 90.0;
  return Weather(scene, nullptr);
}

constexpr std::uint64_t bits(int flake) { return mixed(static_cast<std::uint64_t>(flake)); }

TEST(WindField, SteadyWindIsTheWeathers) {
  const WindField field(windy(3.0), 0.0, 1);
  EXPECT_NEAR(glm::distance(field.common(20.0).way_m, {60.0, 0.0, 0.0}), 0.0, 1e-9);
  EXPECT_EQ(glm::length(field.own_gust(field.moment(20.0), bits(1)).velocity_m_s), 0.0F);
}

TEST(WindField, WaysAreIntegralsOfVelocities) {
  const WindField field(windy(4.0), 0.3, 7);
  const double step_s = 1e-3;
  for (int i = 0; i < 40; ++i) {
    const double time_s = 3.7 * i;
    const glm::dvec3 common =
        (field.common(time_s + step_s).way_m - field.common(time_s - step_s).way_m) /
        (2.0 * step_s);
    EXPECT_NEAR(glm::distance(common, field.common(time_s).velocity_m_s), 0.0, 1e-4) << i;
    const double longer_s = 5e-3;  // of floats
    const glm::dvec3 own =
        glm::dvec3(field.own_gust(field.moment(time_s + longer_s), bits(i)).way_m -
                   field.own_gust(field.moment(time_s - longer_s), bits(i)).way_m) /
        (2.0 * longer_s);
    const glm::dvec3 expected = field.own_gust(field.moment(time_s), bits(i)).velocity_m_s;
    EXPECT_NEAR(glm::distance(own, expected), 0.0, 2e-3) << i;
  }
}

/// The deviation is turbulence times speed, neighbours agree by three quarters.
TEST(WindField, TurbulenceIsSharedByNeighbours) {
  const double speed = 5.0, turbulence = 0.25;
  const WindField field(windy(speed), turbulence, 3);
  glm::dvec3 squares(0.0), products(0.0), mean(0.0);
  const int samples = 60000;
  for (int i = 0; i < samples; ++i) {
    const double time_s = 1.37 * i;
    const glm::dvec3 common = field.common(time_s).velocity_m_s - glm::dvec3(speed, 0.0, 0.0);
    const auto moment = field.moment(time_s);
    const glm::dvec3 one = common + glm::dvec3(field.own_gust(moment, bits(2 * i)).velocity_m_s);
    const glm::dvec3 two =
        common + glm::dvec3(field.own_gust(moment, bits(2 * i + 1)).velocity_m_s);
    mean += one / static_cast<double>(samples);
    squares += one * one / static_cast<double>(samples);
    products += one * two / static_cast<double>(samples);
  }
  const double expected = turbulence * speed;
  EXPECT_NEAR(glm::length(mean), 0.0, 0.03 * expected);
  EXPECT_NEAR(std::sqrt(squares.x), expected, 0.02 * expected);
  EXPECT_NEAR(std::sqrt(squares.y), expected, 0.02 * expected);
  EXPECT_NEAR(std::sqrt(squares.z), 0.5 * expected, 0.02 * expected);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(products[axis] / squares[axis], 0.75, 0.02);
}

std::shared_ptr<const wind::AirFlow> air(double turbulence) {
  return std::make_shared<const wind::AirFlow>(Heightfield(3, 60.0, 2.0F), 0.4, turbulence, 5);
}

// Grass and flakes have one wind: what all flakes about the eye feel are the gusts there, but for
// short ones, and they bring them as far as they blow.
TEST(WindField, OfAirThatMovesGrassHasItsGusts) {
  const double speed = 5.0, turbulence = 0.25;
  const auto flow = air(turbulence);
  const WindField field(windy(speed), turbulence, 3, flow);
  const glm::dvec2 eye_m(21.0, 12.0);
  double products = 0.0, ours = 0.0, theirs = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double time_s = 13.7 * i;
    const double gust = field.common(time_s, eye_m).velocity_m_s.x - speed;
    const wind::Moment now{speed, 90.0, speed * time_s};
    const double of_air = flow->velocity_m_s(eye_m, wind::reference_m, now).x - speed;
    products += gust * of_air;
    ours += gust * gust;
    theirs += of_air * of_air;
  }
  EXPECT_GT(products / std::sqrt(ours * theirs), 0.9);
  EXPECT_LT(ours, theirs);
  EXPECT_GT(ours, 0.7 * theirs);
  for (double time_s = 1.0; time_s < 60.0; time_s *= 1.7) {
    constexpr double step_s = 1e-3;
    const glm::dvec3 moved_m =
        field.common(time_s + step_s, eye_m).way_m - field.common(time_s - step_s, eye_m).way_m;
    EXPECT_LT(glm::distance(moved_m / (2.0 * step_s), field.common(time_s, eye_m).velocity_m_s),
              1e-3);
  }
  EXPECT_NE(field.common(3.0, eye_m).velocity_m_s, field.common(3.0, {60.0, 12.0}).velocity_m_s);
}

TEST(WindField, OwnGustsStayWithinTheirBound) {
  const WindField field(windy(5.0), 1.0, 3);
  float farthest_m = 0.0F;
  for (int i = 0; i < 20000; ++i)
    farthest_m =
        std::max(farthest_m, glm::length(field.own_gust(field.moment(0.31 * i), bits(i)).way_m));
  EXPECT_LT(static_cast<double>(farthest_m), field.farthest_own_gust_m());
  EXPECT_GT(static_cast<double>(farthest_m), 0.5 * field.farthest_own_gust_m());
}

TEST(WindField, ManyFlakesGustsAreThoseOfEach) {
  const WindField field(windy(5.0), 0.4, 3);
  const auto moment = field.moment(17.0);
  Lanes<std::uint64_t> many;
  VectorLanes ways = {}, velocities = {};
  for (std::size_t i = 0; i < lanes; ++i) many[i] = bits(static_cast<int>(i));
  field.add_own_gusts(moment, many, ways, velocities);
  for (std::size_t i = 0; i < lanes; ++i) {
    const WindField::Gust gust = field.own_gust(moment, many[i]);
    ASSERT_EQ(ways.at(i), gust.way_m);
    ASSERT_EQ(velocities.at(i), gust.velocity_m_s);
  }
}

}  // namespace
}  // namespace wold::snow
