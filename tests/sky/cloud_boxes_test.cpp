#include "sky/cloud_boxes.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(CloudBoxes, ColumnsHaveTheLayersDropletsInsideTheWindow) {
  const View view;
  const auto boxes = cloud_boxes(view.clouds, view.windows, view.day, view.camera.eye_m);
  ASSERT_EQ(boxes.size(), 1U);
  const landscape::CloudBox& box = boxes.front();
  ASSERT_EQ(box.extinction_per_m.size(), static_cast<std::size_t>(box.voxels.x) *
                                             static_cast<std::size_t>(box.voxels.y) *
                                             static_cast<std::size_t>(box.voxels.z));
  int clouded = 0;
  for (int j = 0; j < box.voxels.y; j += 7)
    for (int i = 0; i < box.voxels.x; i += 7) {
      double depth = 0.0;
      for (int k = 0; k < box.voxels.z; ++k)
        depth += box.voxel_m * double{box.extinction_per_m[static_cast<std::size_t>(
                                   (k * box.voxels.y + j) * box.voxels.x + i)]};
      const glm::dvec2 at_m = glm::dvec2(box.corner_m) + (glm::dvec2(i, j) + 0.5) * box.voxel_m;
      const double wanted =
          cloud::droplets_per_seen(*view.clouds.layers[0].layer) *
          cloud::optical_depth_at(view.clouds.layers[0], view.clouds.pixel_m, at_m) *
          view.windows[0]->fraction(at_m);
      EXPECT_NEAR(std::exp(-depth), std::exp(-wanted), 1e-3);
      clouded += wanted > 0.1;
    }
  EXPECT_GT(clouded, 100);
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

TEST(CloudBoxes, WindowsStandStillUnderAMovingCamera) {
  View view;
  const CloudWindow before = *view.windows[0];
  view.camera.eye_m.x += 100.0;
  view.camera.target_m.x += 100.0;
  const CloudWindow after = *cloud_windows(view.clouds, view.camera)[0];
  const double voxel_m = view.clouds.layers[0].layer->thickness_m / 32.0;
  const double moved = (after.south_west_m.x - before.south_west_m.x) / voxel_m;
  EXPECT_NEAR(moved, std::round(moved), 1e-9);
  EXPECT_NEAR(moved * voxel_m, 100.0, voxel_m);
  EXPECT_EQ(after.fraction(after.south_west_m), 0.0);
  EXPECT_EQ(after.fraction(after.south_west_m + after.side_m / 2.0), 1.0);
}

// What is volume in the window is not there once more as a sheet.
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
    const glm::dvec3 place_m(centre_m.x + 15.0 * (k - 100), centre_m.y, base_m);
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
