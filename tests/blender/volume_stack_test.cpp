#include "blender/volume_stack.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace wold::blender {
namespace {

using landscape::Landscape;

constexpr double patch_m = 0.6;

/// A camera that looks north over level ground on which nothing stands.
Landscape empty_view() {
  Landscape landscape;
  landscape.patch_m = patch_m;
  landscape.volumes.resize(1);
  landscape.volumes[0].voxels = {30, 30, 20};
  landscape.volumes[0].voxel_m = patch_m / 30.0;
  landscape.camera = {{0.3, -4.0, 1.0}, {0.3, 4.0, 0.2}, 50.0};
  landscape.width_px = 960;
  landscape.height_px = 540;
  return landscape;
}

landscape::Cell cell_at(double east_m, double north_m, const landscape::Part& part = {}) {
  landscape::Cell cell;
  cell.world_from_cell = glm::translate(glm::dmat4(1.0), glm::dvec3(east_m, north_m, 0.0));
  cell.part = part;
  return cell;
}

landscape::CloudBox cloud_at(double height_m) {
  landscape::CloudBox cloud;
  cloud.voxels = {50, 50, 4};
  cloud.voxel_m = 0.5;
  cloud.corner_m = {-12.0, 2.0, height_m};
  return cloud;
}

TEST(VolumeStack, OfNothingIsEmptyAndFogIsEverywhere) {
  Landscape landscape = empty_view();
  EXPECT_EQ(deepest_volume_stack(landscape), 0);
  landscape.fog = landscape::Fog{0.01, glm::vec3(0.1F)};
  EXPECT_EQ(deepest_volume_stack(landscape), 1);
}

/// Cells behind each other are met one after the other.
TEST(VolumeStack, CountsWhatLiesOverEachOtherAndNotBehind) {
  Landscape landscape = empty_view();
  for (int row = 0; row < 12; ++row) landscape.cells.push_back(cell_at(0.0, patch_m * row));
  EXPECT_EQ(deepest_volume_stack(landscape), 1);
  landscape.cells.push_back(cell_at(0.0, 0.5 * patch_m));
  EXPECT_EQ(deepest_volume_stack(landscape), 2);
  for (int more = 0; more < 31; ++more) landscape.cells.push_back(cell_at(0.0, 0.0));
  EXPECT_EQ(deepest_volume_stack(landscape), 33);  // with the one half-way
}

/// Where neighbours lean away from each other their cells are stretched over the gap.
TEST(VolumeStack, KnowsHowFarCellsReach) {
  Landscape landscape = empty_view();
  landscape.cells = {cell_at(0.0, 0.0), cell_at(patch_m + 0.1, 0.0)};
  EXPECT_EQ(deepest_volume_stack(landscape), 1);
  landscape.cells[0].reach = glm::scale(glm::dmat4(1.0), glm::dvec3(1.4, 1.0, 1.0));
  EXPECT_EQ(deepest_volume_stack(landscape), 2);
}

/// All parts of a quarter are shown of the quarter's own volume: sixteen eighths of a side are
/// sixteen volumes over one place.
TEST(VolumeStack, PartsOfAQuarterAreAsManyQuarters) {
  Landscape landscape = empty_view();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const glm::dvec2 low = glm::dvec2(i, j) / 8.0;
      landscape.cells.push_back(cell_at(0.0, 0.0, {low, low + 0.125}));
    }
  EXPECT_EQ(deepest_volume_stack(landscape), 16);
}

TEST(VolumeStack, CountsClouds) {
  Landscape landscape = empty_view();
  landscape.camera.target_m.z = 4.0;
  for (const double height_m : {3.0, 4.0, 20.0}) landscape.clouds.push_back(cloud_at(height_m));
  EXPECT_EQ(deepest_volume_stack(landscape), 2);
}

/// What is behind the camera or beside the picture is in no ray.
TEST(VolumeStack, KnowsWhatIsInThePicture) {
  Landscape landscape = empty_view();
  for (int i = 0; i < 40; ++i) landscape.cells.push_back(cell_at(0.0, -9.0));
  for (int i = 0; i < 40; ++i) landscape.cells.push_back(cell_at(30.0, 2.0));
  EXPECT_EQ(deepest_volume_stack(landscape), 0);
  for (int i = 0; i < 25; ++i) landscape.cells.push_back(cell_at(0.0, -4.3));  // about the eye
  landscape.camera.eye_m.z = 0.2;
  EXPECT_EQ(deepest_volume_stack(landscape), 25);
}

}  // namespace
}  // namespace wold::blender
