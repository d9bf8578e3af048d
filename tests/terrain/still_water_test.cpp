#include "terrain/still_water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "support/places.h"
#include "terrain/ground.h"
#include "terrain/model_lakes.h"

namespace wold::terrain {
namespace {

constexpr int side = 64;

template <class Height>
CellBlock block_of(const Height& height) {
  CellBlock block{{0, 0}, {side, side}, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) block.values.push_back(height(x - side / 2, y - side / 2));
  return block;
}

/// How many cells of 30 m are water.
template <class Height>
std::ptrdiff_t lake_cells(const Height& height) {
  const StillWater water = still_water(block_of(height), 30.0);
  return std::ranges::count_if(water.lake, [](int lake) { return lake >= 0; });
}

double cone_m(int x, int y) { return 80.0 + 3.0 * std::hypot(x, y); }

TEST(StillWater, IsWhereALakeFillsAHollow) {
  const auto lake = [](int x, int y) { return std::max(110.0, cone_m(x, y)); };
  std::ptrdiff_t cells = 0;
  for (int y = -side / 2; y < side / 2; ++y)
    for (int x = -side / 2; x < side / 2; ++x) cells += cone_m(x, y) < 110.0 ? 1 : 0;
  EXPECT_GT(cells, 200);
  // Four more are at 110 m themselves, to the four sides.
  EXPECT_NEAR(static_cast<double>(lake_cells(lake)), static_cast<double>(cells), 12.0);
  const StillWater water = still_water(block_of(lake), 30.0);
  EXPECT_EQ(water.levels, std::vector<double>{110.0});
}

TEST(StillWater, HasAnOutlet) {
  const auto lake = [](int x, int y) {
    return x > 9 && y == 0 ? 110.0 - x : std::max(110.0, cone_m(x, y));
  };
  EXPECT_GT(lake_cells(lake), 200);
}

TEST(StillWater, OfTheSeaIsOneLakeAtZero) {
  EXPECT_EQ(lake_cells([](int x, int) { return x < 0 ? 0.0 : 0.7 * (x + 1); }), side * side / 2);
}

// Whole metres on a valley floor that falls by 1 in 300 and rises to its sides: terraces 10 cells
// long.
TEST(StillWater, IsNotATerraceOfAModelInWholeMetres) {
  EXPECT_EQ(lake_cells([](int x, int y) { return std::rint(0.1 * x + 0.02 * std::abs(y)); }), 0);
  EXPECT_EQ(lake_cells([](int x, int) { return std::rint(0.03 * x); }), 0);
}

TEST(StillWater, IsNotTheFloorOfABowlInWholeMetres) {
  EXPECT_EQ(lake_cells([](int x, int y) { return std::rint(0.01 * (x * x + y * y)); }), 0);
}

TEST(StillWater, IsNotATableMountain) {
  EXPECT_EQ(
      lake_cells([](int x, int y) { return std::min(120.0, 200.0 - 5.0 * std::hypot(x, y)); }), 0);
}

// Of a plain no shore is seen.
TEST(StillWater, IsNotAPlain) {
  EXPECT_EQ(lake_cells([](int, int) { return 42.0; }), 0);
}

TEST(StillWater, IsNoPuddleAndNoRiver) {
  EXPECT_EQ(lake_cells([](int x, int y) { return std::max(83.0, cone_m(x, y)); }), 0);
  EXPECT_EQ(lake_cells([](int x, int y) {
              return std::max(50.0, 50.0 + 5.0 * (std::abs(x) - 1)) + 0.0 * y;
            }),
            3 * side);  // three cells wide: a lake
  EXPECT_EQ(lake_cells([](int x, int) { return 50.0 + 5.0 * std::abs(x); }), 0);
}

TEST(StillWater, IsNotWhereNothingIsKnown) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      lake_cells([&](int x, int y) { return std::hypot(x, y) < 9.0 ? nothing : cone_m(x, y); }), 0);
}

std::string model(const char* name) {
  return (wold::test::tests_folder() / "data" / "terrain" / name).string();
}

scene::Terrain place(const char* name, double size_m) {
  scene::Terrain terrain;
  terrain.elevation = model(name);
  terrain.size_m = size_m;
  terrain.samples = 257;
  return terrain;
}

// Beaver Reservoir (40.118 N, 105.522 W), 2792 m above the sea, is the only water of this model of
// the Colorado Front Range that is more than a few cells wide.
TEST(StillWater, OfTheFrontRangeIsBeaverReservoir) {
  scene::Terrain terrain = place("front_range_srtm_gl3.asc", 6000.0);
  terrain.system = "EPSG:4326";
  terrain.centre = {-105.522, 40.118};
  const auto lakes = model_lakes(terrain, 0.0);
  ASSERT_TRUE(lakes);
  ASSERT_EQ(lakes->levels_m.size(), 1U);
  EXPECT_NEAR(lakes->levels_m.front(), 2792.0, 2.0);
  double area_m2 = 0.0;
  for (const int lake : lakes->number.values())
    area_m2 += lake >= 0 ? std::pow(lakes->number.step_m(), 2) : 0.0;
  EXPECT_NEAR(area_m2, 42 * 71.0 * 92.5, 0.05 * area_m2);
  const Ground ground = make_ground(terrain, 1);
  ASSERT_TRUE(ground.water);
  EXPECT_GT(ground.water->share({3000.0, 3000.0}, 1.0), 0.99);
  terrain.water = scene::WaterSource::none;
  EXPECT_FALSE(make_ground(terrain, 1).water);
}

// A gully in grassland, without water.
TEST(StillWater, OfBijouIsNone) {
  EXPECT_FALSE(model_lakes(place("bijou_grassland_5m.asc", 380.0), 0.0));
}

}  // namespace
}  // namespace wold::terrain
