#include "terrain/river_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.h"

namespace wold::terrain {
namespace {

constexpr double step_m = 10.0;

/// A river of 600 cells' length and three of width, in bends, that falls to the west by 1 %, as
/// measured with a deviation of 3 m.
struct River {
  std::vector<glm::ivec2> places;
  std::vector<double> true_m, measured_m;

  explicit River(double fall = 0.01) {
    for (int x = 0; x < 600; ++x)
      for (int y = -1; y <= 1; ++y) {
        places.push_back({x, y + static_cast<int>(std::lround(10.0 * std::sin(0.05 * x)))});
        true_m.push_back(100.0 + fall * step_m * x);
        const auto k = static_cast<std::uint64_t>(places.size());
        measured_m.push_back(true_m.back() +
                             3.0 * std::sqrt(12.0) * (random_uniform({k, 7, 0, 1}) - 0.5));
      }
  }
};

TEST(RiverLevels, AreThoseOfTheWaterWhateverIsMeasured) {
  const River river;
  const auto levels_m = river_levels_m(river.places, river.measured_m, step_m);
  ASSERT_TRUE(levels_m);
  double squares = 0.0, most = 0.0;
  for (std::size_t k = 0; k < levels_m->size(); ++k) {
    const double off = (*levels_m)[k] - river.true_m[k];
    squares += off * off / static_cast<double>(levels_m->size());
    most = std::max(most, std::abs(off));
  }
  EXPECT_LT(std::sqrt(squares), 0.6);
  EXPECT_LT(most, 1.5);
}

TEST(RiverLevels, RiseUpstreamAndAreEvenAcross) {
  const River river;
  const auto levels_m = river_levels_m(river.places, river.measured_m, step_m);
  ASSERT_TRUE(levels_m);
  for (std::size_t k = 3; k + 3 < levels_m->size(); k += 3) {
    EXPECT_GT((*levels_m)[k + 1], (*levels_m)[k - 2] - 0.02) << k;
    EXPECT_NEAR((*levels_m)[k], (*levels_m)[k + 2], 0.15) << k;
  }
}

// A model has the bridge, not the water below it.
TEST(RiverLevels, GoOnUnderABridge) {
  River river;
  for (std::size_t k = 900; k < 909; ++k) river.measured_m[k] += 60.0;
  const auto levels_m = river_levels_m(river.places, river.measured_m, step_m);
  ASSERT_TRUE(levels_m);
  for (std::size_t k = 3; k + 3 < levels_m->size(); k += 3) {
    EXPECT_GT((*levels_m)[k + 1], (*levels_m)[k - 2] - 0.05) << k;
    EXPECT_NEAR((*levels_m)[k], river.true_m[k], 2.0) << k;
  }
}

// No river climbs a pass: what a map has so is two.
TEST(RiverLevels, AreNoneAcrossAPass) {
  River river;
  for (std::size_t k = 0; k < river.places.size(); ++k)
    river.measured_m[k] = 100.0 - 0.02 * std::abs(river.places[k].x - 300);
  EXPECT_TRUE(river_levels_m(river.places, river.measured_m, step_m));
  for (double& height_m : river.measured_m) height_m = 10.0 * (height_m - 100.0);
  EXPECT_FALSE(river_levels_m(river.places, river.measured_m, step_m));
}

// A model that has trees and banks in some reaches, and a river that hardly falls.
TEST(RiverLevels, AreThoseOfAFlatRiverUnderTrees) {
  River river(0.001);
  for (std::size_t k = 0; k < river.places.size(); ++k)
    if (river.places[k].x % 90 > 70) river.measured_m[k] += 8.0;
  const auto levels_m = river_levels_m(river.places, river.measured_m, step_m);
  ASSERT_TRUE(levels_m);
  for (std::size_t k = 0; k < levels_m->size(); ++k)
    EXPECT_NEAR((*levels_m)[k], river.true_m[k], 1.6) << k;
}

// Two arms round an island.
TEST(RiverLevels, OfArmsAreAsHighWhereTheyMeet) {
  std::vector<glm::ivec2> places;
  std::vector<double> heights_m;
  const auto add = [&](int x, int y) {
    places.push_back({x, y});
    heights_m.push_back(0.05 * (x + std::abs(y)));
  };
  for (int x = 0; x < 100; ++x) add(x, 0);
  for (int x = 100; x < 140; ++x)
    for (const int y : {-5, 5}) add(x, y);
  for (int y = -5; y <= 5; ++y) {
    if (y != 0) add(100 - 1, y);
    add(140, y);
  }
  const auto levels_m = river_levels_m(places, heights_m, step_m);
  ASSERT_TRUE(levels_m);
  for (std::size_t k = 0; k < places.size(); ++k)
    EXPECT_NEAR((*levels_m)[k], heights_m[k], 0.4) << places[k].x << ' ' << places[k].y;
}

TEST(RiverLevels, OfATorrentAreNone) {
  EXPECT_TRUE(river_levels_m(River(0.08).places, River(0.08).measured_m, step_m));
  EXPECT_FALSE(river_levels_m(River(0.15).places, River(0.15).measured_m, step_m));
}

}  // namespace
}  // namespace wold::terrain
