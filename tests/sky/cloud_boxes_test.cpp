#include "sky/cloud_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloud/lifting.h"
#include "sky/cloudy_sky.h"

namespace wold::sky {
namespace {

scene::Scene cumulus_scene() {
  scene::Scene scene;
  scene::CloudLayer layer;
  layer.body = scene::CloudBody::volume;
  layer.cells = {2, 2};
  scene.clouds = {layer};
  return scene;
}

/// The clouds of a scene and a camera that looks at them.
struct View {
  scene::Scene scene = cumulus_scene();
  cloud::CloudState clouds = cloud::Clouds(scene, 16.0).at(0.0);
  light::Daylight day{scene.sun, scene.sky};
  landscape::Camera camera{{20.0, 0.0, 2.0}, {20.0, 15.0, 6.0}, 60.0};
  std::vector<std::optional<CloudWindow>> windows = cloud_windows(clouds, camera);
};

TEST(CloudBoxes, HaveTheLayersDropletsInsideTheWindow) {
  const View view;
  const auto boxes = cloud_boxes(view.clouds, view.windows, view.day, view.camera.eye_m);
  ASSERT_EQ(boxes.size(), 1U);
  const landscape::CloudBox& box = boxes.front();
  EXPECT_EQ(box.voxels, cloud_box_voxels);
  const CloudWindow& window = *view.windows[0];
  const cloud::CloudVolume lifted =
      cloud::lifted(view.clouds.layers[0], view.clouds.pixel_m, window.south_west_m,
                    glm::dvec2(window.side_m), cloud_box_voxels);
  ASSERT_EQ(box.extinction_per_m.size(), lifted.extinction_per_m.size());
  int clouded = 0;
  for (std::size_t i = 0; i < box.extinction_per_m.size(); i += 53) {
    const auto at = static_cast<int>(i);
    const glm::ivec3 voxel(at % box.voxels.x, at / box.voxels.x % box.voxels.y,
                           at / box.voxels.x / box.voxels.y);
    const double wanted = double{lifted.extinction_per_m[i]} *
                          window.fraction(glm::dvec2(lifted.box.centre_m(voxel)));
    EXPECT_NEAR(double{box.extinction_per_m[i]}, wanted, 1e-6);
    clouded += wanted > 0.01;
  }
  EXPECT_GT(clouded, 1000);
}

/// What passes through a volume along a line of sight.
double through(const cloud::CloudVolume& volume, const glm::dvec3& eye_m,
               const glm::dvec3& direction) {
  const cloud::VoxelBox& box = volume.box;
  const double step_m = 0.5 * box.voxel_m.z;
  double depth = 0.0;
  for (double at_m = 0.0; at_m < 8000.0; at_m += step_m) {
    const glm::ivec3 voxel(glm::floor((eye_m + at_m * direction - box.corner_m) / box.voxel_m));
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(voxel, box.voxels)))
      continue;
    depth += step_m * double{volume.extinction_per_m[box.index(voxel)]};
  }
  return std::exp(-depth);
}

// The volume and the heaps that lines of sight follow are the same clouds: nobody sees where one
// ends and the other begins.
TEST(CloudBoxes, HideWhatHeapsHide) {
  const View view;
  const cloud::CloudVolume volume =
      cloud::lifted(view.clouds.layers[0], view.clouds.pixel_m, view.windows[0]->south_west_m,
                    glm::dvec2(view.windows[0]->side_m), cloud_box_voxels);
  const CloudLayerView heaps(view.clouds.layers[0], view.clouds.pixel_m, view.camera.eye_m,
                             view.day, 1e-3, std::nullopt);
  double both = 0.0, volume_alone = 0.0, heaps_alone = 0.0, lines = 0.0;
  for (double azimuth_deg = -20.0; azimuth_deg <= 20.0; azimuth_deg += 1.0)
    for (double elevation_deg = 22.0; elevation_deg <= 40.0; elevation_deg += 1.0) {
      const glm::dvec3 direction =
          light::direction_of(glm::radians(azimuth_deg), glm::radians(elevation_deg));
      const bool by_volume = through(volume, view.camera.eye_m, direction) < 0.3;
      const bool by_heaps = heaps.along(direction).through < 0.3F;
      both += by_volume && by_heaps;
      volume_alone += by_volume && !by_heaps;
      heaps_alone += by_heaps && !by_volume;
      lines += 1.0;
    }
  EXPECT_GT(both, 0.1 * lines);
  EXPECT_LT(volume_alone + heaps_alone, 0.08 * lines) << volume_alone << ' ' << heaps_alone;
}

// A ray's samples lie some two voxels apart.
TEST(CloudBoxes, AreNotDenserThanTheirVoxelsShow) {
  View view;
  view.scene.clouds[0].thickness_m = 2500.0;
  view.clouds = cloud::Clouds(view.scene, 80.0).at(0.0);
  view.windows = cloud_windows(view.clouds, view.camera);
  const auto boxes = cloud_boxes(view.clouds, view.windows, view.day, view.camera.eye_m);
  const float densest_per_m = *std::ranges::max_element(boxes.at(0).extinction_per_m);
  EXPECT_NEAR(double{densest_per_m} * boxes[0].voxel_m, 1.0, 1e-4);
}

// Nearly all of a window lies before the camera, which is above its near end.
TEST(CloudBoxes, WindowsLieWhereTheCameraLooks) {
  View view;
  for (const glm::dvec2 ahead :
       {glm::dvec2(0.0, 1.0), glm::dvec2(0.0, -1.0), glm::dvec2(1.0, 0.0), glm::dvec2(-0.6, 0.8)}) {
    view.camera.target_m = view.camera.eye_m + glm::dvec3(15.0 * ahead, 4.0);
    const CloudWindow window = *cloud_windows(view.clouds, view.camera)[0];
    const glm::dvec2 middle_m = window.south_west_m + window.side_m / 2.0;
    EXPECT_GT(glm::dot(middle_m - glm::dvec2(view.camera.eye_m), ahead), 0.3 * window.side_m);
  }
}

// Voxels are for what is seen: the steeper the camera looks up, the nearer is the window.
TEST(CloudBoxes, WindowsBeginWhereTheViewMeetsTheLayer) {
  View view;
  const double rise_m = view.clouds.layers[0].layer->base_m - view.camera.eye_m.z;
  for (const double pitch_deg : {5.0, 20.0, 45.0, 60.0, 89.0}) {
    const double pitch = glm::radians(pitch_deg);
    view.camera.target_m =
        view.camera.eye_m + 10.0 * glm::dvec3(0.0, std::cos(pitch), std::sin(pitch));
    const CloudWindow window = *cloud_windows(view.clouds, view.camera)[0];
    const double highest_deg = std::min(pitch_deg + 30.0, 90.0);
    const double first_m = rise_m / std::tan(glm::radians(highest_deg));
    for (const double further_m : {20.0, 800.0, 1600.0})
      EXPECT_GT(
          window.fraction(glm::dvec2(view.camera.eye_m) + glm::dvec2(0.0, first_m + further_m)),
          0.99)
          << pitch_deg;
  }
}

TEST(CloudBoxes, WindowsStandStillUnderAMovingCamera) {
  View view;
  const CloudWindow before = *view.windows[0];
  view.camera.eye_m.x += 100.0;
  view.camera.target_m.x += 100.0;
  const CloudWindow after = *cloud_windows(view.clouds, view.camera)[0];
  const double voxel_m = view.clouds.layers[0].layer->thickness_m / cloud_box_voxels.z;
  const double moved = (after.south_west_m.x - before.south_west_m.x) / voxel_m;
  EXPECT_NEAR(moved, std::round(moved), 1e-9);
  EXPECT_NEAR(moved * voxel_m, 100.0, voxel_m);
  EXPECT_EQ(after.fraction(after.south_west_m), 0.0);
  EXPECT_EQ(after.fraction(after.south_west_m + after.side_m / 2.0), 1.0);
}

// What is volume in the window is not there once more as a sheet. Lines of sight are followed that
// leave the layer within the window.
TEST(CloudBoxes, SheetsLeaveTheWindowToTheVolume) {
  const View view;
  const CloudySky sheets(view.day, view.clouds, view.camera.eye_m);
  const CloudySky beyond(view.day, view.clouds, view.camera.eye_m, CloudySky::usual_finest_rad,
                         view.windows);
  const CloudySky clear(view.day, {}, view.camera.eye_m);
  const double base_m = view.clouds.layers[0].layer->base_m;
  const glm::dvec2 centre_m = view.windows[0]->south_west_m + view.windows[0]->side_m / 2.0;
  int clouded = 0;
  for (int k = 0; k < 200; ++k) {
    const glm::dvec3 place_m(centre_m.x + 10.0 * (k - 100), centre_m.y, base_m);
    const glm::dvec3 direction = glm::normalize(place_m - view.camera.eye_m);
    EXPECT_EQ(beyond.radiance(direction), clear.radiance(direction));
    clouded += sheets.radiance(direction) != clear.radiance(direction);
  }
  EXPECT_GT(clouded, 20);
  const glm::dvec3 far = glm::normalize(glm::dvec3(0.0, view.windows[0]->side_m + 3000.0, base_m));
  EXPECT_EQ(beyond.radiance(far), sheets.radiance(far));
}

}  // namespace
}  // namespace wold::sky
