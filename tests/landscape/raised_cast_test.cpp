#include "landscape/raised_cast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace wold::landscape {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

const glm::dvec3 origin_m(100.0, -50.0, 7.0);

/// A cone of 45 degrees, many times: its tip 1 m over the ground at each of 10 by 10 places, 4 m
/// apart.
RaisedGround cones() {
  constexpr std::uint32_t ways = 64;
  RaisedGround raised{origin_m, {}, {}};
  for (int cone = 0; cone < 100; ++cone) {
    const glm::vec3 foot_m(4.0F * static_cast<float>(cone % 10),
                           4.0F * static_cast<float>(cone / 10), 0.0F);
    const auto tip = static_cast<std::uint32_t>(raised.points_m.size());
    raised.points_m.push_back(foot_m + glm::vec3(0, 0, 1));
    for (std::uint32_t way = 0; way < ways; ++way) {
      const double turn = 2.0 * 3.14159265358979 * way / ways;
      raised.points_m.push_back(foot_m + glm::vec3(std::cos(turn), std::sin(turn), 0.0));
      raised.triangles.emplace_back(tip, tip + 1 + way, tip + 1 + (way + 1) % ways);
    }
  }
  return raised;
}

TEST(RaisedCast, MeetsConesWhereTheyAre) {
  const RaisedGround raised = cones();
  const RaisedCast cast(raised);
  // Half a metre over the ground a cone is a metre wide.
  for (const int row : {0, 3, 9})
    EXPECT_NEAR(cast.distance_m(origin_m + glm::dvec3(-5.0, 4.0 * row, 0.5), {1, 0, 0}, infinite),
                4.5, 0.002);
  EXPECT_EQ(cast.distance_m(origin_m + glm::dvec3(-5.0, 2.0, 0.5), {1, 0, 0}, infinite), infinite);
  EXPECT_EQ(cast.distance_m(origin_m + glm::dvec3(-5.0, 4.0, 0.5), {1, 0, 0}, 3.0), 3.0);
  EXPECT_EQ(cast.distance_m(origin_m + glm::dvec3(-5.0, 4.0, 0.5), {-1, 0, 0}, infinite), infinite);
}

TEST(RaisedCast, KnowsNormalsOnConesAndNoneBeside) {
  const RaisedGround raised = cones();
  const RaisedCast cast(raised);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const double turn = 6.2831853 * random_uniform({k, 1}), from_m = 0.9 * random_uniform({k, 2});
    const glm::dvec2 way(std::cos(turn), std::sin(turn));
    const auto normal = cast.normal(
        origin_m + glm::dvec3(8.0 + from_m * way.x, 12.0 + from_m * way.y, 1.0 - from_m));
    ASSERT_TRUE(normal);
    EXPECT_NEAR(glm::dot(*normal, glm::normalize(glm::dvec3(way, 1.0))), 1.0, 0.003);
    EXPECT_FALSE(cast.normal(
        origin_m + glm::dvec3(8.0 + from_m * way.x, 12.0 + from_m * way.y, 1.1 - from_m)));
  }
  EXPECT_FALSE(cast.normal(origin_m + glm::dvec3(10.0, 12.0, 0.0)));
}

}  // namespace
}  // namespace wold::landscape
