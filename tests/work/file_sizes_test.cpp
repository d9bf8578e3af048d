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

// autumn_to_winter at day 60: finest texels under snow have as many bytes as fresh ones.
TEST(VolumeSizes, UnderSnowAreLowerButHoldAsMuch) {
  const scene::Grass grass;
  const VolumeSize fresh = volume_size({grass}, 0, 0.0, 0.0),
                   snowy = volume_size({grass}, 0, 0.0, 0.5);
  EXPECT_LT(snowy.voxels, 0.8 * fresh.voxels);
  EXPECT_EQ(snowy.filled, fresh.filled);
  scene::Grass dense;
  dense.blades *= 4;
  const VolumeSize full = volume_size({dense}, 3, 0.0, 1.0);
  EXPECT_EQ(full.filled, full.voxels);
}

// Every 3 cm, but every 2 cm where snow lies; as fine as a large picture shows them with it, too.
TEST(GroundSamples, AreNoFewerWhereSnowLies) {
  scene::Scene scene;
  scene.terrain.size_m = 60.0;
  const film::FrameDemand bare;
  film::FrameDemand snowy;
  snowy.has_snow = true;
  EXPECT_EQ(ground_samples(scene, bare), 2001.0 * 2001.0);
  EXPECT_EQ(ground_samples(scene, snowy), 3001.0 * 3001.0);
  scene.render.size_px = {3840, 2160};
  EXPECT_GT(ground_samples(scene, bare), 3001.0 * 3001.0);
  EXPECT_EQ(ground_samples(scene, snowy), ground_samples(scene, bare));
}

// Frames share a terrain while it is bare, and have their own under snow that shapes it.
TEST(SceneBytes, CountATerrainForEachSnow) {
  film::Request request;
  scene::Scene& scene = request.scene;
  scene.terrain.samples = 33;
  scene.growth.cover = 0.0;
  scene.ageing.frames = {0.0, 0.0, 0.0};
  scene.film.frame_seconds = 3600.0;
  scene.weather.temperature_c = -3.0;
  scene.weather.precipitation_mm_h = 2.0;
  const exporter::FileCosts one_a_sample{.shared_terrain_sample = 1.0};
  const auto terrains = [&](const std::vector<int>& frames) {
    request.frames = frames;
    const film::FilmDemand demand(request, place::growing_ground(scene));
    return scene_bytes(scene, one_a_sample, demand).of(frames.size()) / (33 * 33);
  };
  EXPECT_DOUBLE_EQ(terrains({1}), 1.0);
  EXPECT_DOUBLE_EQ(terrains({1, 2, 3}), 3.0) << "bare, and two under snow";
  EXPECT_DOUBLE_EQ(terrains({2, 3}), 2.0);
  scene.snow_cover.cover = scene::CoverModel::paper;
  EXPECT_DOUBLE_EQ(terrains({1, 2, 3}), 1.0) << "the paper's snow has no depth";
}

}  // namespace
}  // namespace wold::work
