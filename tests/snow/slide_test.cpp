#include "snow/slide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/random.h"
#include "terrain/relief.h"

namespace wold::snow {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A rugged mountain of metre steps, up to 60 degrees and more.
Heightfield mountain(int samples) {
  Heightfield terrain(samples, samples - 1.0);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const double from_top_m = std::hypot(i - 0.5 * samples, j - 0.4 * samples);
      const auto index = static_cast<std::uint64_t>(j * samples + i);
      terrain.at(i, j) =
          static_cast<float>(1.4 * std::max(0.4 * samples - from_top_m, 0.0) +
                             0.6 * random_uniform({7, key_of("mountain"), index, 0}));
    }
  return terrain;
}

bool is_pit(const Heightfield& terrain, int i, int j) {
  for (int y = std::max(j - 1, 0); y <= std::min(j + 1, terrain.samples() - 1); ++y)
    for (int x = std::max(i - 1, 0); x <= std::min(i + 1, terrain.samples() - 1); ++x)
      if (terrain.at(x, y) < terrain.at(i, j)) return false;
  return true;
}

TEST(SnowSlide, HasThePublishedLimits) {
  const auto across_slope_m = [](double slope_deg) {
    return max_depth_m(slope_deg) * std::cos(glm::radians(slope_deg));
  };
  EXPECT_NEAR(across_slope_m(30.0), 3.079, 5e-4);
  EXPECT_NEAR(across_slope_m(45.0), 1.118, 5e-4);
  EXPECT_NEAR(across_slope_m(60.0), 0.445, 5e-4);
  EXPECT_NEAR(across_slope_m(75.0), 0.1475, 5e-5);
  EXPECT_TRUE(std::isinf(max_depth_m(9.99)));
}

TEST(SnowSlide, LeavesNoSlopeTooDeepAndLosesNothing) {
  const Heightfield terrain = mountain(97);
  SnowpackField packs(terrain.values().size(), {600.0, 2.5, 0.3});
  const double water_mm = sum(packs.water_mm), depth_m = sum(packs.depth_m);
  SnowSlide(terrain).settle(packs);
  EXPECT_NEAR(sum(packs.water_mm), water_mm, 1e-9 * water_mm);
  EXPECT_NEAR(sum(packs.depth_m), depth_m, 1e-9 * depth_m);
  int slid = 0;
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i) {
      const double deep_m = packs.depth_m[static_cast<std::size_t>(j * terrain.samples() + i)];
      slid += deep_m != 2.5;
      if (is_pit(terrain, i, j)) continue;
      const double slope = terrain::slope_deg(terrain, i, j);
      ASSERT_LE(deep_m, max_depth_m(slope) + 1e-6) << i << ' ' << j;
    }
  EXPECT_GT(slid, 1000);
}

TEST(SnowSlide, StaysInAPitAndOnLevelGround) {
  const Heightfield level(9, 8.0, 5.0F);
  SnowpackField packs(81, {1e5, 500.0, 0.0});
  SnowSlide(level).settle(packs);
  EXPECT_EQ(packs.depth_m, std::vector<double>(81, 500.0));

  Heightfield bowl(9, 8.0);
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) bowl.at(i, j) = static_cast<float>(std::hypot(i - 4, j - 4));
  packs = SnowpackField(81, {1e3, 5.0, 0.0});
  SnowSlide(bowl).settle(packs);
  EXPECT_NEAR(sum(packs.water_mm), 81e3, 1e-6);
  EXPECT_GT(packs.depth_m[40], 100.0);  // 45 degrees keep 1.58 m of 5
}

TEST(SnowSlide, FallsTowardsWhereTheSurfaceDrops) {
  Heightfield roof(5, 4.0);  // 60 degrees to the east and to the west
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) roof.at(i, j) = static_cast<float>(-1.7 * std::abs(i - 2));
  roof.at(2, 2) += 0.5F;
  SnowpackField packs(25, {0.0, 0.0, 0.0});
  packs.depth_m[12] = 40.0, packs.water_mm[12] = 4000.0;
  const SnowSlide slide(roof);
  slide.settle(packs);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(packs.depth_m[5 * j + i], packs.depth_m[5 * j + 4 - i], 1e-12);
}

// A step of 1.7 m above level ground, with 3 m of snow in one place: of its three lower neighbours
// the one under 2 m of snow lies 2.7 m below the snow's surface, the others 4.7 m, and they get as
// much.
TEST(SnowSlide, IsSharedByTheDropsOfTheSurface) {
  Heightfield steps(5, 4.0);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) steps.at(i, j) = static_cast<float>(1.7 * std::max(j - 1, 0));
  SnowpackField packs(25, {0.0, 0.0, 0.0});
  packs.depth_m[12] = 3.0, packs.water_mm[12] = 300.0;
  packs.depth_m[6] = 2.0, packs.water_mm[6] = 200.0;
  SnowSlide(steps).settle(packs);
  const double to_the_deep_m = packs.depth_m[6] - 2.0;
  ASSERT_GT(to_the_deep_m, 0.3);
  EXPECT_NEAR(packs.depth_m[7] / to_the_deep_m, 4.7 / 2.7, 1e-5);
  EXPECT_NEAR(packs.depth_m[8] / to_the_deep_m, 4.7 / 2.7, 1e-5);
}

TEST(SnowSlide, ToleratesATerrainOfOneCell) {
  Heightfield terrain(2, 1.0);
  terrain.at(0, 0) = 1.0F;
  SnowpackField packs(4, {5000.0, 20.0, 0.0});
  SnowSlide(terrain).settle(packs);
  EXPECT_NEAR(sum(packs.depth_m), 80.0, 1e-12);
  EXPECT_LT(packs.depth_m[0], 20.0);
}

}  // namespace
}  // namespace wold::snow
