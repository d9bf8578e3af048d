#include "terrain/ledges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/statistics.h"
#include "terrain/ground.h"

namespace wold::terrain {
namespace {

/// Of a slope that rises that much to the north, on a grid of 20 m.
FactorMap ledges_of(double rise, double rock_slope_deg, float growth = 0.0F) {
  Heightfield slope(65, 6400.0);
  for (int j = 0; j < slope.samples(); ++j)
    for (int i = 0; i < slope.samples(); ++i)
      slope.at(i, j) = static_cast<float>(rise * j * slope.step_m());
  scene::Terrain look;
  look.rock_slope_deg = rock_slope_deg;
  return ledges(Surface(slope, nullptr, {{{1000.0, 1000.0}, 4000.0}, 201}),
                FactorMap(2, 6400.0, growth), look, 3);
}

TEST(Ledges, AreAllOfWhatIsNoRock) {
  for (const auto& [rise, rock_slope_deg] : {std::pair(0.7, 42.0), std::pair(1.7, 75.0)}) {
    const FactorMap all = ledges_of(rise, rock_slope_deg);
    EXPECT_EQ(std::ranges::count(all.values(), 1.0F), 201 * 201) << rise;
  }
}

TEST(Ledges, AreFewerTheSteeperRockIs) {
  const double gentle = mean(ledges_of(1.0, 42.0).values());  // 45 degrees
  const double steep = mean(ledges_of(1.73, 42.0).values());  // 60
  const double wall = mean(ledges_of(4.0, 42.0).values());    // 76
  EXPECT_GT(gentle, 0.7);
  EXPECT_LT(gentle, 0.98);
  EXPECT_LT(steep, 0.55);
  EXPECT_GT(steep, 0.15);
  EXPECT_LT(wall, 0.15);
}

// Grass holds soil, and soil holds snow.
TEST(Ledges, AreAllOfWhatGrassGrowsOn) {
  const FactorMap grown = ledges_of(1.73, 42.0, 1.0F);
  EXPECT_EQ(std::ranges::count(grown.values(), 1.0F), 201 * 201);
}

// Wind takes the snow of spurs, and gullies gather it.
TEST(Ledges, AreMoreInGulliesThanOnSpurs) {
  scene::Terrain look;
  look.shape = scene::TerrainShape::mountain;
  look.size_m = 2000.0;
  look.samples = 65;
  look.hill_height_m = 1200.0;
  look.talus_deg = 80.0;
  const Ground land = make_ground(look, 3);
  ASSERT_TRUE(land.finer);
  const Surface surface(land.heights_m, land.finer.get(), {{{0.0, 0.0}, 2000.0}, 801});
  const FactorMap map = ledges(surface, FactorMap(2, 2000.0), look, 3);
  std::vector<float> spurs, gullies;
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i) {
      if (std::abs(surface.slope_deg(i, j) - 55.0) > 3.0) continue;
      if (surface.exposure(i, j) > 0.7) spurs.push_back(map.at(i, j));
      if (surface.exposure(i, j) < -0.7) gullies.push_back(map.at(i, j));
    }
  ASSERT_GT(spurs.size(), 500U);
  ASSERT_GT(gullies.size(), 500U);
  EXPECT_GT(mean(gullies), mean(spurs) + 0.15);
}

// Rock may begin on level ground.
TEST(Ledges, OfLevelRockAreAllOfIt) {
  const FactorMap level = ledges_of(0.0, 0.0);
  EXPECT_GT(*std::ranges::min_element(level.values()), 0.9F);
}

}  // namespace
}  // namespace wold::terrain
