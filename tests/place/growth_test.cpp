#include "place/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/image.h"
#include "meadow/cells.h"
#include "support/film_parts.h"
#include "support/temporary_folder.h"

namespace wold::place {
namespace {

scene::Scene flat_square(double size_m) {
  scene::Scene scene;
  scene.terrain.size_m = size_m;
  return scene;
}

Heightfield plane(double size_m, double rise) {
  Heightfield terrain(101, size_m);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) = static_cast<float>(rise * j * terrain.step_m());
  return terrain;
}

double mean(const FactorMap& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0) /
         static_cast<double>(map.values().size());
}

// The noise is equalised: the area that is grown over is the fraction that was asked for.
TEST(Growth, CoversTheShareOfTheGround) {
  scene::Scene scene = flat_square(100.0);
  scene.growth.feature_m = 0.8;
  const Heightfield ground = plane(100.0, 0.0);
  for (const double fraction : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    scene.growth.cover = fraction;
    EXPECT_NEAR(mean(growth_map(scene, ground)), fraction, 0.015) << fraction;
  }
}

TEST(Growth, LeavesPathsBare) {
  const scene::Scene scene = flat_square(40.0);
  const Heightfield ground = plane(40.0, 0.0);
  const terrain::Paths paths(ground, {{{2.0, 20.0, 38.0, 20.0}, 2.0}}, 1, nullptr);
  const FactorMap growth = growth_map(scene, ground, {.paths = &paths});
  EXPECT_LT(growth.sample(20.0, 20.0), 0.35F);
  EXPECT_EQ(growth.sample(20.0, 27.0), 1.0F);
}

// On a slope of 25 degrees that faces the noon sun, 47 degrees north, as sunlight over level ground
// says: sin 68 / sin 43 = 1.36. Other slopes, small terrains and what users say have all of it.
TEST(Growth, LeavesSunnySlopesOfLargeTerrainsBareInPart) {
  constexpr double tangent = 0.4663;
  const auto grown = [](double size_m, double rise, const std::string& photo = "") {
    scene::Scene scene = flat_square(size_m);
    scene.terrain.photo = photo;
    scene.growth.steepest_deg = 80.0;
    const Heightfield ground = plane(size_m, rise);
    return mean(growth_map(scene, terrain::Surface(ground, nullptr, {ground.square(), 101})));
  };
  EXPECT_NEAR(grown(4000.0, tangent), 1.0 - 0.4 * glm::smoothstep(1.0, 1.45, 1.36), 0.03);
  EXPECT_NEAR(grown(4000.0, -tangent), 1.0, 1e-6);
  EXPECT_NEAR(grown(4000.0, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(grown(4000.0, tangent, "photo.tif"), 1.0, 1e-6);
  EXPECT_NEAR(grown(60.0, tangent), 1.0, 1e-6);
}

TEST(Growth, StopsAtSlopesAndHeights) {
  scene::Scene scene = flat_square(20.0);
  scene.growth.steepest_deg = 30.0;
  EXPECT_EQ(mean(growth_map(scene, plane(20.0, std::tan(0.70)))), 0.0);  // 40 degrees
  EXPECT_EQ(mean(growth_map(scene, plane(20.0, std::tan(0.35)))), 1.0);  // 20 degrees
  scene.growth.lowest_m = 2.0;
  scene.growth.highest_m = 4.0;
  scene.growth.feature_m = 0.2;
  const FactorMap band = growth_map(scene, plane(20.0, 0.3));  // 0 to 6 m
  EXPECT_EQ(band.sample(10.0, 1.8 / 0.3), 0.0F);
  EXPECT_EQ(band.sample(10.0, 3.0 / 0.3), 1.0F);
  EXPECT_EQ(band.sample(10.0, 4.2 / 0.3), 0.0F);
}

// White in the north-east quarter of a picture whose first row is the north.
TEST(Growth, FollowsTheMask) {
  const test::TemporaryFolder folder("growth");
  Image mask(2, 2, 3);
  std::fill_n(mask.pixel(1, 0), 3, 1.0F);
  write_image(folder.path() / "mask.png", mask, PixelFormat::uint8);
  scene::Scene scene = flat_square(20.0);
  scene.growth.mask = (folder.path() / "mask.png").string();
  const FactorMap growth = growth_map(scene, plane(20.0, 0.0));
  EXPECT_EQ(growth.sample(19.0, 19.0), 1.0F);
  EXPECT_EQ(growth.sample(1.0, 19.0), 0.0F);
  EXPECT_EQ(growth.sample(19.0, 1.0), 0.0F);
}

// A mask may hold what is no number.
TEST(Growth, DamagedMasksAreBlackThere) {
  const test::TemporaryFolder folder("growth");
  Image mask(2, 2, 3);
  std::fill(mask.values.begin(), mask.values.end(), std::numeric_limits<float>::quiet_NaN());
  write_image(folder.path() / "mask.exr", mask, PixelFormat::float32);
  scene::Scene scene = flat_square(5.0);
  scene.growth.mask = (folder.path() / "mask.exr").string();
  EXPECT_EQ(mean(growth_map(scene, plane(5.0, 0.0))), 0.0);
}

// Cells stand where something grows; blades on as many as the ground is grown over.
TEST(Growth, DecidesWhichCellsStand) {
  scene::Scene scene = flat_square(30.0);
  scene.grass.patch_m = 0.5;
  scene.grass.far_field_below_pixels = 0.0;
  scene.camera.eye_m = {15.0, 0.0};
  scene.camera.eye_height_m = 60.0;
  scene.camera.target_m = {15.0, 15.0};
  const Heightfield ground = plane(30.0, 0.0);
  FactorMap growth(61, 30.0);
  for (int j = 0; j < growth.samples(); ++j)
    for (int i = 0; i < growth.samples(); ++i) growth.at(i, j) = i < 30 ? 0.0F : 0.3F;
  for (const meadow::CellChoice& choice :
       meadow::choose_cells(scene, ground, growth, test::mixtures_of(scene, ground),
                            test::withering_of(scene, ground), test::grass_of(scene, 1)))
    EXPECT_GE(choice.cell.x, 28);  // rows begin up to half a cell to either side
  const double texels = static_cast<double>(
      meadow::choose_cells(scene, ground, growth, test::mixtures_of(scene, ground),
                           test::withering_of(scene, ground), test::grass_of(scene, 1))
          .size());
  scene.render.grass = scene::GrassForm::blades;
  const double blades = static_cast<double>(
      meadow::choose_cells(scene, ground, growth, test::mixtures_of(scene, ground),
                           test::withering_of(scene, ground), test::grass_of(scene, 1))
          .size());
  EXPECT_NEAR(blades / texels, 0.3, 0.03);
}

TEST(Growth, LeavesBouldersBare) {
  scene::Scene scene = flat_square(100.0);
  scene.terrain.boulders_per_hectare = 150.0;
  const Heightfield ground = plane(100.0, 0.0);
  const terrain::Boulders boulders(ground, scene.terrain, scene.seed, nullptr, nullptr);
  const terrain::Surface surface(ground, nullptr, {ground.square(), 1001}, {.boulders = &boulders});
  const FactorMap growth = growth_map(scene, surface);
  int on_boulders = 0;
  for (int j = 0; j < growth.samples(); ++j)
    for (int i = 0; i < growth.samples(); ++i) {
      const double cover = surface.boulder(i, j).cover;
      if (cover == 1.0) {
        ++on_boulders;
        EXPECT_EQ(growth.at(i, j), 0.0F);
      }
      if (cover == 0.0) {
        EXPECT_EQ(growth.at(i, j), 1.0F);
      }
    }
  EXPECT_GT(on_boulders, 5000);
}

}  // namespace
}  // namespace wold::place
