#include "sky/blowing_snow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "place/site.h"
#include "place/view.h"
#include "snow/blowing_snow.h"
#include "support/temporary_folder.h"

namespace wold::sky {
namespace {

scene::Scene stormy(double size_m) {
  scene::Scene scene;
  scene.terrain.size_m = size_m;
  scene.terrain.samples = 65;
  scene.snow_cover.initial_mm = 60.0;
  scene.weather.temperature_c = -10.0;
  scene.wind.speed_m_s = 16.0;
  scene.wind.heading_deg = 90.0;
  scene.camera.eye_m = {0.5 * size_m, 0.3 * size_m};
  scene.camera.target_m = {0.5 * size_m, 0.8 * size_m};
  return scene;
}

/// Its first frame's volumes, over snow that is loose everywhere, in the light of a low sun in the
/// north, before the camera.
landscape::Landscape blown(const scene::Scene& scene, double loose = 1.0, float sunlit = 1.0F) {
  const test::TemporaryFolder snow("blown");
  const place::Site site =
      place::make_site(scene, nullptr, snow.path(), place::Sketch{33, 33, 33, 33});
  landscape::Landscape landscape;
  landscape.terrain = site.terrain;
  landscape.camera = place::resolved_camera(scene.camera, site.terrain, 0.0);
  landscape.sky = Image(8, 4, 3);
  std::ranges::fill(landscape.sky.values, 0.1F);
  landscape.daylight = {glm::normalize(glm::dvec3(0.0, 1.0, 0.2)), glm::vec3(3.0F),
                        glm::vec3(0.3F)};
  const auto field = [&] {
    return SnowField{[loose](const glm::dvec2&) { return loose; },
                     FactorMap(2, scene.terrain.size_m, sunlit), 0.8};
  };
  add_blowing_snow(scene, site, field, landscape);
  return landscape;
}

/// Optical depth of all volumes along a plumb line, by voxels; `above_m`: of what is that high over
/// the ground alone.
double depth_over(const landscape::Landscape& landscape, const glm::dvec2& at_m,
                  double above_m = 0.0) {
  const double ground_m = landscape.terrain.sample(at_m.x, at_m.y);
  double depth = 0.0;
  for (const landscape::CloudBox& box : landscape.clouds) {
    const glm::ivec2 column((at_m - glm::dvec2(box.corner_m)) / box.voxel_m);
    if (column.x < 0 || column.y < 0 || column.x >= box.voxels.x || column.y >= box.voxels.y)
      continue;
    for (int z = 0; z < box.voxels.z; ++z) {
      const double centre_m = box.corner_m.z + (z + 0.5) * box.voxel_m;
      if (centre_m < ground_m + above_m) continue;
      depth += box.voxel_m * box.extinction_per_m[static_cast<std::size_t>(
                                 (z * box.voxels.y + column.y) * box.voxels.x + column.x)];
    }
  }
  return depth;
}

TEST(BlowingSnowVolumes, AreOneOverASmallSquareAndTwoOverAWideOne) {
  EXPECT_EQ(blown(stormy(48.0)).clouds.size(), 1U);
  const landscape::Landscape wide = blown(stormy(400.0));
  ASSERT_EQ(wide.clouds.size(), 2U);
  EXPECT_GT(wide.clouds[0].voxel_m, wide.clouds[1].voxel_m);  // the nearest is the last
}

TEST(BlowingSnowVolumes, AreNoneWithoutStormSnowOrWill) {
  scene::Scene breeze = stormy(48.0);
  breeze.wind.speed_m_s = 5.0;
  breeze.wind.turbulence = 0.0;
  EXPECT_TRUE(blown(breeze).clouds.empty());
  scene::Scene without = stormy(48.0);
  without.snow_cover.blowing = 0.0;
  EXPECT_TRUE(blown(without).clouds.empty());
  EXPECT_TRUE(blown(stormy(48.0), 0.0).clouds.empty());
}

TEST(BlowingSnowVolumes, LieOnTheGround) {
  const landscape::Landscape landscape = blown(stormy(48.0));
  constexpr double steep_m = 0.5;  // the ground's rise within a voxel, and more
  for (double x = 4.0; x < 46.0; x += 5.3)
    for (double y = 4.0; y < 46.0; y += 5.3) {
      EXPECT_GT(depth_over(landscape, {x, y}), 0.0);
      EXPECT_EQ(depth_over(landscape, {x, y}, snow::blown_depth_m + steep_m), 0.0);
    }
}

// Twice as much of it, and half as much where half of the ground is loose.
TEST(BlowingSnowVolumes, AreAsMuchAsTheSceneAndTheGroundSay) {
  scene::Scene scene = stormy(48.0);
  const glm::dvec2 at_m(20.0, 30.0);
  constexpr double above_m = 1.0;  // where it is not thicker than can be seen
  const double depth = depth_over(blown(scene), at_m, above_m);
  EXPECT_NEAR(depth_over(blown(scene, 0.5), at_m, above_m), 0.5 * depth, 1e-6 * depth);
  scene.snow_cover.blowing = 2.0;
  EXPECT_NEAR(depth_over(blown(scene), at_m, above_m), 2.0 * depth, 1e-6 * depth);
}

// Along a line from the eye into the coarser volume nothing of the haze is lost or doubled: means
// over the wind's way, in which streamers are left out, change little from step to step.
TEST(BlowingSnowVolumes, PassIntoEachOther) {
  scene::Scene scene = stormy(400.0);
  scene.terrain.hill_height_m = 0.0;
  scene.terrain.relief_m = 0.0;
  scene.wind.turbulence = 0.0;
  const landscape::Landscape landscape = blown(scene);
  const double y0 = scene.camera.eye_m[1];
  const auto mean_depth = [&](double y) {
    double sum = 0.0;
    for (int i = 0; i < 60; ++i)
      for (int j = 0; j < 8; ++j) sum += depth_over(landscape, {175.0 + 0.83 * i, y + 0.6 * j});
    return sum / 480.0;
  };
  const double near = mean_depth(y0 + 10.0);
  for (double ahead_m = 20.0; ahead_m < 90.0; ahead_m += 10.0)
    EXPECT_NEAR(mean_depth(y0 + ahead_m) / near, 1.0, 0.25) << ahead_m;
}

// Grains send most of the sun's light on along its way.
TEST(BlowingSnowVolumes, ShineBeforeTheSun) {
  scene::Scene scene = stormy(48.0);
  const landscape::Landscape towards = blown(scene);
  std::swap(scene.camera.eye_m, scene.camera.target_m);
  const landscape::Landscape away = blown(scene);
  const auto mean = [](const landscape::Landscape& landscape, double from_y, double to_y) {
    const landscape::CloudBox& box = landscape.clouds.back();
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < box.radiance.size(); ++i) {
      const double y_m =
          box.corner_m.y +
          box.voxel_m * static_cast<double>(i / static_cast<std::size_t>(box.voxels.x) %
                                            static_cast<std::size_t>(box.voxels.y));
      if (box.extinction_per_m[i] <= 0.0F || y_m < from_y || y_m > to_y) continue;
      sum += box.radiance[i].g;
      ++count;
    }
    return sum / count;
  };
  EXPECT_GT(mean(towards, 26.0, 40.0), 3.0 * mean(away, 10.0, 24.0));
  std::swap(scene.camera.eye_m, scene.camera.target_m);
  EXPECT_LT(3.0 * mean(blown(scene, 1.0, 0.0F), 26.0, 40.0), mean(towards, 26.0, 40.0));
}

}  // namespace
}  // namespace wold::sky
