#include "snow/drifting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

namespace wold::snow {
namespace {

Heightfield terrain_of(int samples, const std::function<double(double, double)>& height_m) {
  Heightfield terrain(samples, samples - 1.0);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) terrain.at(i, j) = static_cast<float>(height_m(i, j));
  return terrain;
}

constexpr double from_west_deg = 90.0, from_south_deg = 0.0, from_east_deg = 270.0;

TEST(Shelter, IsNoneOnAPlane) {
  const FactorMap shelter = shelter_deg(Heightfield(65, 64.0, 3.0F), 75.0);
  for (float degrees : shelter.values()) EXPECT_NEAR(degrees, 0.0F, 1e-3F);
}

TEST(Shelter, IsTheSlopeUpwind) {
  const Heightfield tilted = terrain_of(65, [](double x, double) { return 0.5 * x; });
  const double up_deg = glm::degrees(std::atan(0.5));
  EXPECT_NEAR(shelter_deg(tilted, from_east_deg).at(20, 32), up_deg, 1e-3);
  // Of falling ground the gentlest fall counts, at the window's edge.
  const double down_deg = -glm::degrees(std::atan(0.5 * std::cos(glm::radians(15.0))));
  EXPECT_NEAR(shelter_deg(tilted, from_west_deg).at(40, 32), down_deg, 1e-3);
}

TEST(Shelter, OfAWallAsHighAsItIsFarIs45Degrees) {
  const auto wall = [](double along) { return along >= 50.0 && along <= 51.0 ? 10.0 : 0.0; };
  const Heightfield across = terrain_of(101, [&](double x, double) { return wall(x); });
  EXPECT_NEAR(shelter_deg(across, from_west_deg).at(61, 50), 45.0, 1e-4);
  EXPECT_NEAR(shelter_deg(across, from_east_deg).at(40, 50), 45.0, 1e-4);
  const Heightfield along = terrain_of(101, [&](double, double y) { return wall(y); });
  EXPECT_NEAR(shelter_deg(along, from_south_deg).at(50, 61), 45.0, 1e-4);
  // To windward of it the wall is not seen, nor from farther than 100 m.
  EXPECT_NEAR(shelter_deg(across, from_west_deg).at(40, 50), 0.0F, 1e-3F);
  const Heightfield far = terrain_of(201, [&](double x, double) { return x < 2.0 ? 10.0 : 0.0; });
  EXPECT_NEAR(shelter_deg(far, from_west_deg).at(150, 50), 0.0F, 1e-3F);
  EXPECT_GT(shelter_deg(far, from_west_deg).at(80, 50), 5.0F);
}

TEST(Drifting, MovesSnowAndMakesNone) {
  const Heightfield hills = terrain_of(
      129, [](double x, double y) { return 6.0 * std::sin(0.2 * x) * std::cos(0.13 * y); });
  const FactorMap factor = drift_factor(hills, 75.0, 0.7);
  const auto& values = factor.values();
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0) / values.size(), 1.0, 1e-6);
  const auto [min, max] = std::ranges::minmax(values);
  EXPECT_LT(min, 0.7F);
  EXPECT_GT(max, 1.1F);
  EXPECT_NEAR(drift_weight(15.0, 0.5), 1.0 + 0.5 * std::tanh(1.0), 1e-12);
}

TEST(Drifting, ToleratesATerrainOfOneCell) {
  const FactorMap drift = drift_factor(Heightfield(2, 30.0, 1.0F), 45.0, 1.0);
  for (float factor : drift.values()) EXPECT_NEAR(factor, 1.0F, 1e-6F);
}

}  // namespace
}  // namespace wold::snow
