#include "wind/gust_drift.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold::wind {
namespace {

constexpr double speed_m_s = 6.0, height_m = 10.0;
const glm::dvec2 place_m(12.0, 31.0);

Moment north_east(double time_s) { return {speed_m_s, 45.0, speed_m_s * time_s}; }

// All of its waves together are the gust there; the way is what it blows over time.
TEST(GustDrift, IsTheGustsThereAndTheirWay) {
  const Gusts gusts(Profile(0.3), 0.25, 9);
  for (int i = 0; i < 30; ++i) {
    const double time_s = 5.3 * i;
    const auto drift = [&](double t) {
      return gust_drift(gusts, place_m, height_m, 0.0, north_east(t));
    };
    const glm::dvec3 gust = speed_m_s * gust_at(gusts.waves(height_m, north_east(time_s)), place_m);
    const glm::dvec3 velocity = drift(time_s).velocity_m_s;
    const double half = std::sqrt(0.5);
    EXPECT_NEAR(half * (velocity.x + velocity.y), gust.x, 1e-9);  // along it
    EXPECT_NEAR(half * (velocity.x - velocity.y), gust.y, 1e-9);  // to its right
    EXPECT_NEAR(velocity.z, gust.z, 1e-9);
    constexpr double step_s = 1e-4;
    const glm::dvec3 moved_m = drift(time_s + step_s).way_m - drift(time_s - step_s).way_m;
    EXPECT_LT(glm::distance(moved_m / (2.0 * step_s), velocity), 1e-3);
  }
}

TEST(GustDrift, LeavesShortGustsOut) {
  const Gusts gusts(Profile(0.3), 0.25, 9);
  const auto deviation = [&](double shortest_m) {
    double squares = 0.0;
    for (int i = 0; i < 400; ++i)
      squares += std::pow(
          gust_drift(gusts, place_m, height_m, shortest_m, north_east(7.7 * i)).velocity_m_s.x, 2);
    return std::sqrt(squares / 400.0);
  };
  EXPECT_LT(deviation(100.0), 0.9 * deviation(6.0));
  EXPECT_LT(deviation(6.0), deviation(0.0));
  EXPECT_EQ(deviation(5000.0), 0.0);
}

}  // namespace
}  // namespace wold::wind
