#include "grass/texel/lods.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "grass/texel/baking.h"
#include "grass/texel/columns.h"
#include "grass/texel/coverage.h"
#include "grass/texel/rasterise.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

double area_m2(const VolumeData& volume) {
  return test::sum(volume.density) * volume.shape.voxel_volume_m3();
}

Transmittances seen_through(const VolumeData& volume) {
  return transmittances(VoxelRows(volume.shape, volume.voxel), volume.density);
}

VolumeData random_volume(const TexelShape& shape) {
  VolumeData volume;
  volume.shape = shape;
  volume.turns = {0};
  for (std::uint32_t voxel = 0; voxel < shape.voxels(); ++voxel) {
    if (random_uniform({4, 5, voxel, 6}) > 0.05) continue;
    volume.voxel.push_back(voxel);
    volume.density.push_back(static_cast<float>(50.0 * random_uniform({4, 5, voxel, 7})));
  }
  volume.emission = {std::vector<glm::vec3>(volume.size(), {0.3F, 0.2F, 0.1F})};
  return volume;
}

TEST(Lods, CoarserKeepsAreaAndConstantEmission) {
  VolumeData volume = random_volume({62, 41, 0.004});
  for (int side : {30, 14, 7}) {
    const VolumeData coarse = coarser(volume, side);
    EXPECT_NEAR(area_m2(coarse) / area_m2(volume), 1.0, 1e-5);
    EXPECT_NEAR(coarse.shape.patch_m(), volume.shape.patch_m(), 1e-12);
    EXPECT_GE(coarse.shape.height * coarse.shape.voxel_m,
              volume.shape.height * volume.shape.voxel_m - 1e-9);
    for (const glm::vec3& emission : coarse.emission[0])
      ASSERT_LT(glm::distance(emission, glm::vec3(0.3F, 0.2F, 0.1F)), 1e-5F);
    volume = coarse;
  }
}

TEST(Lods, EmissionIsTheMeanByArea) {
  VolumeData fine;
  fine.shape = {2, 2, 0.5};
  fine.voxel = {0, 3};
  fine.density = {3.0F, 1.0F};
  fine.turns = {2};
  fine.emission = {{{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}};
  const VolumeData coarse = coarser(fine, 1);
  ASSERT_EQ(coarse.size(), 1U);
  EXPECT_FLOAT_EQ(coarse.density[0], 0.5F);
  EXPECT_EQ(coarse.turns, fine.turns);
  EXPECT_LT(glm::distance(coarse.emission[0][0], glm::vec3(0.75F, 0.25F, 0.0F)), 1e-6F);
}

// Jensen's inequality: averaging makes opaque, fitting takes that back.
// What is too faint to see leaves its area to the others.
TEST(Lods, WithoutFaintVoxelsKeepTheArea) {
  VolumeData volume;
  volume.shape = {4, 4, 0.01};
  volume.voxel = {0, 5, 9, 20, 33};
  volume.density = {30.0F, 0.1F, 12.0F, 0.5F, 8.0F};  // 0.02 over a voxel's side is 2 per metre
  const VolumeData shown = without_faint(volume);
  EXPECT_EQ(shown.voxel, (std::vector<std::uint32_t>{0, 9, 33}));
  EXPECT_NEAR(test::sum(shown.density), test::sum(volume.density), 1e-4);
  EXPECT_NEAR(shown.density[0] / shown.density[1], 30.0 / 12.0, 1e-5);
}

// Meadows lean: one azimuth would not speak for the others.
TEST(Lods, AreFittedFromAzimuthsAtRightAngles) {
  for (const double elevation_deg : {15.0, 45.0}) {
    const auto directions = transmittance_directions(elevation_deg);
    ASSERT_EQ(directions.size(), 2U);
    EXPECT_NEAR(glm::dot(glm::dvec2(directions[0]), glm::dvec2(directions[1])), 0.0, 1e-12);
    for (const glm::dvec3& direction : directions)
      EXPECT_NEAR(direction.z, std::sin(elevation_deg * test::degree), 1e-12);
  }
}

TEST(Lods, FittedDensityLetsThroughWhatTheFineOneDoes) {
  const VolumeData fine = random_volume({62, 41, 0.004});
  const Transmittances wanted = seen_through(fine);
  const VolumeData coarse = coarser(fine, 30);
  const auto fitted = fitted_density(coarse.shape, coarse.voxel, coarse.density, wanted);
  const auto now = transmittances(VoxelRows(coarse.shape, coarse.voxel), fitted);
  EXPECT_LT(Transmittances::difference(now, wanted), 2e-3);
  EXPECT_GT(*std::min_element(fitted.begin(), fitted.end()), 0.0F);
}

// A shrub lets nothing through, however dense: it has no say in the fit, and becomes no denser than
// anyone sees for the sake of the grass around it.
TEST(Lods, FittedDensityOfAShrubIsNoMoreThanSolid) {
  VolumeData fine = random_volume({62, 41, 0.004});
  for (std::size_t i = 0; i < fine.size(); ++i)
    if (const glm::ivec3 at = fine.shape.coordinates(fine.voxel[i]); at.x < 20 && at.y < 20)
      fine.density[i] *= 4000.0F;
  const VolumeData coarse = coarser(fine, 30);
  Transmittances wanted = seen_through(fine);
  wanted.value[2] -= 0.02;  // as of blades, which stand in rows
  const auto fitted = fitted_density(coarse.shape, coarse.voxel, coarse.density, wanted);
  EXPECT_LE(*std::ranges::max_element(fitted) * coarse.shape.voxel_m, 8.0 + 1e-4);
  EXPECT_GT(*std::ranges::max_element(fitted) * coarse.shape.voxel_m, 4.0);
}

/// What the opaque blades let through, from an elevation of Transmittances.
double blades_let_through(const PointDynamics& patch, double patch_m, std::size_t elevation) {
  return blade_transmittance(patch.blades(), patch.poses(), patch_m,
                             transmittance_directions(Transmittances::elevations_deg[elevation]));
}

TEST(Lods, OfAWitheringMeadowMatchTheFinestAndTheBlades) {
  const scene::Scene scene = test::small_scene();
  const TexelShape shape = test::small_shape(126);
  const std::vector<int> sides = {126, 62, 30};
  const AgeingModel model(scene.ageing, scene.grass.specular);
  const auto blades = test::small_blades();
  PointDynamics dynamics(model, blades, sample_points(blades, shape, 6.0, 5), 0.0002);
  for (double weathering : {0.0, 0.3, 0.917}) {
    dynamics.advance_to(weathering);
    const Texel texel = rasterise_points(dynamics.points(), shape);
    const auto lods =
        bake_lods(texel, {&dynamics, 1}, test::slanting_light(), {24.0F, 0.0045}, sides, {0});
    ASSERT_EQ(lods.size(), sides.size());
    const auto finest = seen_through(lods[0]);
    for (const VolumeData& lod : lods)
      EXPECT_LT(Transmittances::difference(finest, seen_through(lod)), 0.01)
          << "side " << lod.shape.side << " at " << weathering;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(finest.value[i], blades_let_through(dynamics, shape.patch_m(), i), 0.02);
    for (const VolumeData& lod : lods) {
      const auto seen = [](const VolumeData& volume) {
        return mean_radiance(VoxelRows(volume.shape, volume.voxel), volume.density,
                             volume.emission[0], direction_at(30.0 * test::degree, 0.4));
      };
      EXPECT_NEAR(seen(lod).g / seen(lods[0]).g, 1.0, 0.02);
    }
  }
}

}  // namespace
}  // namespace wold::grass
