#include "terrain/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "support/elevation_raster.h"
#include "support/temporary_folder.h"
#include "terrain/ground.h"
#include "terrain/highest_around.h"
#include "terrain/known_land.h"
#include "terrain/made_up_land.h"
#include "terrain/resampling.h"

namespace wold::terrain {
namespace {

class SurroundingsTest : public testing::Test {
 protected:
  /// A model of land that rises to the east and falls to the north.
  std::string model(const char* name, double size_m, double cell_m, double lift_m = 0.0,
                    double east_m = 0.0) {
    return test::write_elevation(
        folder_.path() / name, {size_m, cell_m, east_m},
        [&](double east, double north) { return 700.0 + lift_m + 0.05 * east - 0.02 * north; });
  }

  wold::test::TemporaryFolder folder_{"surroundings"};
};

scene::Terrain square_of(const std::string& elevation, const std::string& surroundings = "") {
  scene::Terrain terrain;
  terrain.elevation = elevation;
  terrain.surroundings = surroundings;
  terrain.size_m = 1000.0;
  terrain.samples = 101;
  terrain.relief_m = 0.0;
  return terrain;
}

Surroundings around(const scene::Terrain& terrain, double reach_m) {
  return {terrain, make_ground(terrain, 3).heights_m, 3, reach_m};
}

/// How much higher the land is at a place than in the square's middle.
double rise_m(const Surroundings& land, const glm::dvec2& from_middle_m) {
  const glm::dvec2 middle_m = land.square().corner_m + 0.5 * land.square().size_m;
  return land.height_m(middle_m + from_middle_m) - land.height_m(middle_m);
}

// The land's rise by its law, but for UTM's scale.
void expect_slope(const Surroundings& land, const glm::dvec2& from_middle_m, double within_m) {
  EXPECT_NEAR(rise_m(land, from_middle_m), 0.05 * from_middle_m.x - 0.02 * from_middle_m.y,
              within_m)
      << from_middle_m.x << " " << from_middle_m.y;
}

TEST_F(SurroundingsTest, AreTheRestOfTheElevationModel) {
  const Surroundings land = around(square_of(model("dem.tif", 9000.0, 30.0)), 20000.0);
  EXPECT_GE(land.reach_m(), 20000.0);
  for (const glm::dvec2& at_m :
       {glm::dvec2(700.0, 0.0), {-1200.0, 900.0}, {2000.0, -2500.0}, {4000.0, 4000.0}})
    expect_slope(land, at_m, 0.5);
}

// The other model's heights count from another zero.
TEST_F(SurroundingsTest, AreThoseOfACoarserModelFartherOut) {
  const std::string near = model("near.tif", 3000.0, 30.0);
  const std::string far = model("far.tif", 40000.0, 400.0, 55.0);
  const Surroundings land = around(square_of(near, far), 15000.0);
  for (const glm::dvec2& at_m : {glm::dvec2(1200.0, 0.0), {-2500.0, 3000.0}, {9000.0, -9000.0}})
    expect_slope(land, at_m, 3.0);
}

// They are made when many threads ask at once, and are what they are to a single one.
TEST_F(SurroundingsTest, AreMadeOnceForAllThreads) {
  scene::Terrain terrain;
  const Heightfield ground = make_ground(terrain, 3).heights_m;
  const Surroundings asked_by_many(terrain, ground, 3, 5000.0),
      asked_by_one(terrain, ground, 3, 5000.0);
  const auto place_m = [](std::size_t i) {
    return glm::dvec2(-100.0 * static_cast<double>(i), 60.0);
  };
  std::vector<double> heights_m(40);
  parallel_for(heights_m.size(),
               [&](std::size_t i) { heights_m[i] = asked_by_many.height_m(place_m(i)); });
  for (std::size_t i = 0; i < heights_m.size(); ++i)
    EXPECT_EQ(heights_m[i], asked_by_one.height_m(place_m(i))) << i;
}

// Whoever is stopped while making them leaves it to the next one.
TEST_F(SurroundingsTest, AreMadeWhenTheyAreAskedFor) {
  scene::Terrain terrain;
  const Heightfield ground = make_ground(terrain, 3).heights_m;
  auto scope = std::make_unique<StopScope>([] { throw InterruptedError(); });
  const Surroundings land(terrain, ground, 3, 5000.0);
  EXPECT_THROW(land.height_m({-100.0, 60.0}), InterruptedError);
  scope.reset();
  EXPECT_EQ(land.height_m({-100.0, 60.0}),
            Surroundings(terrain, ground, 3, 5000.0).height_m({-100.0, 60.0}));
}

// Nobody knows what is there: it goes on from the border without a step, and neither leaves the
// heights of such land nor stays level.
TEST_F(SurroundingsTest, GoOnWhereNoModelReaches) {
  scene::Terrain terrain;
  terrain.size_m = 2000.0;
  terrain.samples = 201;
  terrain.hill_height_m = 200.0;
  terrain.relief_m = 40.0;
  terrain.relief_feature_m = 700.0;
  const Heightfield ground = make_ground(terrain, 3).heights_m;
  const Surroundings land(terrain, ground, 3, 60000.0);
  double steps_m = 0.0;
  int count = 0;
  for (double along_m = 50.0; along_m < 2000.0; along_m += 100.0)
    for (const glm::dvec2& border_m :
         {glm::dvec2(along_m, 2000.0), {along_m, 0.0}, {0.0, along_m}, {2000.0, along_m}}) {
      const glm::dvec2 outside_m = border_m + 0.01 * (border_m - 1000.0);
      steps_m += std::abs(land.height_m(outside_m) - ground.sample(outside_m.x, outside_m.y));
      ++count;
    }
  EXPECT_LT(steps_m / count, 5.0);  // 10 m farther out; the ground's own slopes are as steep
  double lowest = 1e9, highest = -1e9;
  for (double east_m = -30000.0; east_m < 32000.0; east_m += 500.0)
    for (double north_m = -30000.0; north_m < 32000.0; north_m += 500.0) {
      if (std::max(std::abs(east_m), std::abs(north_m)) < 6000.0) continue;
      const double height_m = land.height_m({east_m, north_m});
      lowest = std::min(lowest, height_m);
      highest = std::max(highest, height_m);
    }
  EXPECT_GT(highest - lowest, 200.0);
  EXPECT_LT(highest - lowest, 3500.0);
}

// Land that is seen from near has features below the steps of the heights that are kept: at the
// places of these, where nothing else could differ. A map with such steps shows none. At the
// square's border the land is the square's.
TEST_F(SurroundingsTest, HaveFeaturesBelowTheirSteps) {
  scene::Terrain terrain;
  terrain.size_m = 2000.0;
  terrain.samples = 201;
  terrain.hill_height_m = 200.0;
  const Heightfield ground = make_ground(terrain, 3).heights_m;
  const Surroundings land(terrain, ground, 3, 20000.0);
  const double step_m = land.step_m({-100.0, 500.0});
  double finer_m = 0.0;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 at_m =
        glm::dvec2(-2000.0, -2000.0) + step_m * glm::dvec2(20 + i % 20, 20 + i / 20);
    finer_m += std::abs(land.height_m(at_m) - land.coarse_height_m(at_m)) / 400.0;
    EXPECT_NEAR(land.height_m(at_m, step_m), land.coarse_height_m(at_m), 1e-3);
    EXPECT_NEAR(glm::length(land.up(at_m, step_m)), 1.0, 1e-9);
  }
  EXPECT_GT(finer_m, 0.02);
  EXPECT_LT(finer_m, 5.0);
  double wall_m = 0.0;
  for (int i = 0; i < 220; ++i) {
    const glm::dvec2 border_m(-1e-6, 3.0 + 9.0 * i);
    const double ground_m{ground.sample(border_m.x, border_m.y)};
    wall_m += std::abs(land.height_m(border_m) - ground_m) / 220.0;
  }
  EXPECT_LT(wall_m, 0.3);  // the ground has features of its own below those steps
}

// Far and near, where squares go over into each other, and at tops: nothing is above the bound,
// which does not lie far above all.
TEST_F(SurroundingsTest, AreNowhereAboveTheirHighest) {
  const Surroundings land = around(square_of(""), 30000.0);
  const glm::dvec2 middle_m(500.0);
  double highest_m = std::numeric_limits<double>::lowest(), above_m = 0.0;
  int count = 0;
  for (double distance_m = 1.0; distance_m < 40000.0; distance_m *= 1.003, ++count) {
    const glm::dvec2 at_m = middle_m + distance_m * glm::dvec2(std::cos(count), std::sin(count));
    const double height_m = land.height_m(at_m), bound_m = land.highest_m(at_m);
    ASSERT_LE(height_m, bound_m) << distance_m;
    ASSERT_LE(land.coarse_height_m(at_m), bound_m) << distance_m;
    ASSERT_LE(bound_m, land.highest_m()) << distance_m;
    highest_m = std::max(highest_m, height_m);
    above_m += bound_m - height_m;
  }
  EXPECT_LT(land.highest_m(), 2.0 * highest_m);
  EXPECT_LT(above_m / count, 0.2 * highest_m);
}

/// A place's height by cubic convolution.
double convolved_m(const Heightfield& map, const glm::dvec2& at_m) {
  const glm::dvec2 corner = glm::floor(at_m);
  const auto of_column = cubic_weights(at_m.x - corner.x),
             of_row = cubic_weights(at_m.y - corner.y);
  double sum_m = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sum_m +=
          of_column[static_cast<std::size_t>(i)] * of_row[static_cast<std::size_t>(j)] *
          double{map.at(static_cast<int>(corner.x) + i - 1, static_cast<int>(corner.y) + j - 1)};
  return sum_m;
}

// Spikes and holes, and a wall next to a block, which convolution makes heights above the highest
// sample of: no block may forget what lies next to it, and no block may be forgotten, small ones at
// the end neither. Where land is level the bound is the land.
TEST(HighestAround, IsAboveWhateverIsBetweenSamples) {
  Heightfield spikes(36, 35.0), wall(36, 35.0, 10.0F);
  for (std::size_t i = 0; i < spikes.values().size(); ++i)
    spikes.values()[i] = random_uniform({i, 1, 2, 3}) < 0.5 ? 10.0F : -10.0F;
  for (int row = 0; row < 36; ++row) wall.at(17, row) = -10.0F;
  wall.at(34, 34) = 30.0F;
  for (const Heightfield& map : {spikes, wall}) {
    const HighestAround highest(map);
    for (double y = 1.25; y < 34.0; y += 0.25)
      for (double x = 1.25; x < 34.0; x += 0.25)
        ASSERT_GE(highest.highest_m({x, y}), convolved_m(map, {x, y})) << x << ' ' << y;
    EXPECT_EQ(highest.highest_m({-9.0, 50.0}), highest.highest_m({0.0, 35.0}));
  }
  EXPECT_NEAR(HighestAround(wall).highest_m({30.0, 20.0}), 10.0, 0.01);
}

TEST_F(SurroundingsTest, NeedOneCoordinateSystem) {
  const std::string with = model("with.tif", 3000.0, 30.0);
  const std::filesystem::path without = folder_.path() / "without.asc";
  std::ofstream(without) << "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 900\n"
                            "1 2 3\n4 5 6\n7 8 9\n";
  try {
    around(square_of(with, without.string()), 5000.0);
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("terrain.surroundings"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("coordinate system"), std::string::npos);
  }
}

// A model of another place is a mistake, not land at some height.
TEST_F(SurroundingsTest, HaveLandInCommonWithTheElevationModel) {
  scene::Terrain terrain = square_of(model("dem.tif", 3000.0, 30.0));
  terrain.surroundings = model("elsewhere.tif", 3000.0, 300.0, 0.0, 90000.0);
  try {
    around(terrain, 5000.0);
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("elsewhere.tif"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("it has none there"), std::string::npos);
  }
}

TEST(KnownLand, IsFilledInBetween) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  GroundMap<double> heights_m(65, 640.0, nothing);
  for (int j = 0; j < 65; ++j) {
    heights_m.at(0, j) = 10.0;
    heights_m.at(64, j) = 50.0;
  }
  const KnownLand land = filled_in(heights_m);
  EXPECT_EQ(land.heights_m.at(0, 7), 10.0);
  EXPECT_NEAR(land.heights_m.at(32, 32), 30.0, 2.0);
  EXPECT_LT(land.heights_m.at(5, 32), 25.0);
  EXPECT_EQ(land.distance_m.at(64, 3), 0.0);
  EXPECT_NEAR(land.distance_m.at(32, 32), 320.0, 1e-9);
}

TEST(KnownLand, KnowsDistancesWithinEightPercent) {
  GroundMap<double> heights_m(101, 1000.0, std::numeric_limits<double>::quiet_NaN());
  heights_m.at(20, 30) = 7.0;
  const KnownLand land = filled_in(heights_m);
  for (const auto& [i, j] : {std::pair(80, 90), {20, 99}, {50, 40}, {0, 0}}) {
    const double true_m = 10.0 * std::hypot(i - 20, j - 30);
    EXPECT_NEAR(land.distance_m.at(i, j), true_m, 0.0825 * true_m);
    EXPECT_EQ(land.heights_m.at(i, j), 7.0);
  }
}

/// A square of that deviation.
Heightfield uneven(double size_m, float deviation_m) {
  Heightfield ground(65, size_m);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i) ground.at(i, j) = (i + j) % 2 == 0 ? deviation_m : -deviation_m;
  return ground;
}

// Its deviation is as its law has it: that of the ground, over half of its square, by distance^0.7.
TEST(MadeUpLand, RisesAsTheGroundDoes) {
  const MadeUpLand land(uneven(4000.0, 30.0F), 5);
  double sum = 0.0, squares = 0.0;
  constexpr int places = 90;
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i) {
      const double height_m = land.height_m({i * 3100.0, j * 3100.0}, 50.0, 1e6);
      sum += height_m;
      squares += height_m * height_m;
    }
  const double mean = sum / (places * places);
  const double deviation_m = 30.0 * std::pow(8000.0 / 2000.0, 0.7);
  EXPECT_NEAR(mean, 0.0, 0.15 * deviation_m);
  EXPECT_NEAR(std::sqrt(squares / (places * places) - mean * mean), deviation_m,
              0.15 * deviation_m);
}

/// Mean and standard deviation of land's heights, metres, at places all over it, so far from what
/// is known.
struct Heights {
  double mean, deviation;
};
Heights heights_of(const MadeUpLand& land, double from_known_m) {
  constexpr int side = 60;
  constexpr double apart_m = 3113.7;  // far from any multiple of where the land repeats
  double sum = 0.0, squares = 0.0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double height_m = land.height_m({i * apart_m, j * apart_m}, 1.0, from_known_m);
      sum += height_m;
      squares += height_m * height_m;
    }
  const double mean = sum / (side * side);
  return {mean, std::sqrt(std::max(0.0, squares / (side * side) - mean * mean))};
}

// No plain lies around a small square, and no wall. At each distance the land is as high as its law
// has it for features of that size, the largest that have begun there: within a factor of two,
// since small ones are high where large ones are.
TEST(MadeUpLand, BeginsWithSmallFeaturesAtOnce) {
  const MadeUpLand land(uneven(60.0, 3.0F), 5);
  EXPECT_EQ(heights_of(land, 0.0).deviation, 0.0);
  for (const double from_known_m : {32.0, 125.0, 500.0, 2000.0}) {
    const double law_m = 3.0 * std::pow(from_known_m / 30.0, 0.7);
    const Heights heights = heights_of(land, from_known_m);
    EXPECT_GT(heights.deviation, 0.5 * law_m) << from_known_m;
    EXPECT_LT(heights.deviation, 2.0 * law_m) << from_known_m;
    EXPECT_LT(std::abs(heights.mean), 0.2 * law_m) << from_known_m;
  }
}

// What a map shows and what a finer one adds to it are what the finer one shows.
TEST(MadeUpLand, IsShownPieceByPiece) {
  const MadeUpLand land(uneven(4000.0, 30.0F), 5);
  double added_m = 0.0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 at_m(1237.0 * i, 911.0 * i);
    const double finer_m = land.finer_m(at_m, {80.0, 10.0}, 500.0);
    EXPECT_NEAR(land.height_m(at_m, 80.0, 500.0) + finer_m, land.height_m(at_m, 10.0, 500.0), 1e-9);
    added_m += std::abs(finer_m) / 200.0;
  }
  EXPECT_GT(added_m, 0.1);
}

// The most that there may be is not much more than there is somewhere.
TEST(MadeUpLand, IsNowhereFinerThanItsMost) {
  const MadeUpLand land(uneven(4000.0, 30.0F), 3);
  const MadeUpLand::Steps steps{40.0, 5.0};
  const double most_m = land.most_finer_m(steps);
  double highest_m = 0.0;
  for (double y_m = 0.0; y_m < 8000.0; y_m += 41.0)
    for (double x_m = 0.0; x_m < 8000.0; x_m += 37.0)
      highest_m = std::max(highest_m, land.finer_m({x_m, y_m}, steps, 1e6));
  EXPECT_LE(highest_m, most_m);
  EXPECT_GT(highest_m, 0.2 * most_m);
}

TEST(MadeUpLand, IsLevelWhereTheGroundIs) {
  const MadeUpLand land(Heightfield(17, 40.0, 3.0F), 5);
  EXPECT_NEAR(land.height_m({5000.0, 900.0}, 10.0, 1e6), 0.0, 1e-3);
}

}  // namespace
}  // namespace wold::terrain
