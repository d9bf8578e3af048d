#include "work/file_sizes.h"

#include <gtest/gtest.h>

#include "scene/species.h"

namespace wold::work {
namespace {

TEST(VolumeSizes, OfOneSpeciesAreThePatchs) {
  const scene::Scene scene;
  const VolumeSize all = VolumeSizes(scene).of(2, {0}, 1);
  const VolumeSize patch = volume_size({scene.grass}, 1, 0.0, 0.0);
  EXPECT_EQ(all.voxels, patch.voxels);
  EXPECT_EQ(all.filled, patch.filled);
}

// Boxes are as high as the highest species that stands in them.
TEST(VolumeSizes, AreThoseOfAVariantsMixture) {
  scene::Scene scene;
  scene.species = scene::species_of(scene);
  scene.species.push_back(scene.species[0]);
  scene.species[1].plant.height_m = 3.0 * scene.grass.height_m;
  scene.species[1].habitat.cover = 0.5;
  const VolumeSizes sizes(scene);
  const VolumeSize both = sizes.of(0, {0}, 0);
  const VolumeSize low = sizes.of(scene.grass.variants, {0}, 0);
  EXPECT_NEAR(both.voxels / low.voxels, 3.0, 0.1);
  EXPECT_EQ(low.voxels, volume_size({scene.grass}, 0, 0.0, 0.0).voxels);
  EXPECT_GT(both.filled, 1.3 * low.filled);
}

// Withered leaves lie, and snow presses them down; flowers stand where they did.
TEST(VolumeSizes, OfFlowersStayAsHigh) {
  const scene::Grass grass;
  scene::Flower flower;
  flower.petals = 8;
  const double fresh = volume_size({grass, flower}, 0, 0.0, 0.0).voxels;
  EXPECT_EQ(volume_size({grass, flower}, 0, 1.0, 1.0).voxels, fresh);
  EXPECT_LT(volume_size({grass}, 0, 1.0, 1.0).voxels, 0.5 * fresh);
  EXPECT_GT(volume_size({grass, flower}, 0, 0.0, 0.0).filled,
            1.1 * volume_size({grass}, 0, 0.0, 0.0).filled);
}

}  // namespace
}  // namespace wold::work
