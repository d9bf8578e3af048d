#include "place/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "place/each_in_view.h"
#include "place/growth.h"
#include "terrain/ground.h"
#include "terrain/lighting.h"
#include "terrain/surface.h"

namespace wold::place {
namespace {

// Twice as wide as high, 90 degrees across: the picture's edges are 1 and 0.5 to the side of what
// is 1 ahead.
TEST(View, SeesWhatIsInsideThePicture) {
  const View view({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100);
  const auto sees = [&](double right, double up) {
    return view.may_see({10.0 * right, 10.0, 10.0 * up}, 1e-6);
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(sees(0.99 * sign, 0.0));
    EXPECT_FALSE(sees(1.01 * sign, 0.0));
    EXPECT_TRUE(sees(0.0, 0.49 * sign));
    EXPECT_FALSE(sees(0.0, 0.51 * sign));
  }
  EXPECT_FALSE(view.may_see({0, -1, 0}, 0.5));
  EXPECT_TRUE(view.may_see({0, -1, 0}, 1.5));
}

TEST(View, MeasuresLengthsInPixels) {
  const View view({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100);
  EXPECT_NEAR(view.pixels(1.0, {0, 10, 0}), 10.0, 1e-9);
  EXPECT_NEAR(view.pixels(1.0, {0, 6, 8}), 10.0, 1e-9);
}

// Between four heights of which two opposite ones are 8 m higher, bilinear ground is 4 m high. The
// mesh of renderers is cut from south-west to north-east: through the low ones or the high ones.
TEST(Camera, StandsOverTheMesh) {
  constexpr double step_m = 30.0;
  scene::Camera camera;
  camera.eye_m = {0.5 * step_m, 0.5 * step_m};
  camera.eye_height_m = 1.7;
  camera.target_m = {0.25 * step_m, 0.5 * step_m};
  camera.target_height_m = 0.0;
  Heightfield terrain(2, step_m);
  terrain.at(1, 0) = terrain.at(0, 1) = 8.0F;
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).eye_m.z, 1.7, 1e-6);
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).target_m.z, 2.0, 1e-6);
  terrain.at(0, 0) = terrain.at(1, 1) = 16.0F;
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).eye_m.z, 17.7, 1e-6);
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).target_m.z, 14.0, 1e-6);
}

TEST(Camera, KeepsHalfOfItsHeightOverSnowThatLiesAtFirst) {
  const Heightfield level(2, 30.0);
  scene::Scene scene;
  scene.terrain.size_m = 30.0;
  scene.camera.eye_m = scene.camera.target_m = {10.0, 10.0};
  scene.camera.eye_height_m = 1.7;
  const auto eye_m = [&](double water_mm) {
    scene.snow_cover.initial_mm = water_mm;
    return camera_of_frame(scene, level, 1).eye_m.z;
  };
  EXPECT_NEAR(eye_m(0.0), 1.7, 1e-9);
  EXPECT_NEAR(eye_m(100.0), 1.7, 1e-9);  // 0.43 m
  EXPECT_NEAR(eye_m(300.0), 1.03 + 0.85, 0.01);
  scene.camera.eye_end = {20.0, 10.0, 0.4};
  scene.ageing.frames = {0.0, 0.0};
  EXPECT_NEAR(camera_of_frame(scene, level, 2).eye_m.z, 1.03 + 0.2, 0.01);
  scene.snow_cover.cover = scene::CoverModel::paper;  // has no depth
  EXPECT_NEAR(eye_m(300.0), 1.7, 1e-9);
}

TEST(View, IsNotAskedForAllGround) {
  const Square square{{-1.0, 4.0}, 3.0};
  const View view = View({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100).outside(square).reaching(0.5);
  EXPECT_FALSE(view.may_see_ground({0.0, 5.0, 0.0}, 100.0));
  EXPECT_TRUE(view.may_see_ground({0.0, 3.9, 0.0}, 0.0));
  EXPECT_TRUE(view.may_see_ground({0.0, 7.1, 0.0}, 0.0));
  EXPECT_DOUBLE_EQ(margin_in_view_m(view, 0.01), 0.5);
  EXPECT_DOUBLE_EQ(margin_in_view_m(view, 2.0), 4.0);
}

/// Waves of land, 2 km wide.
Heightfield waves() {
  Heightfield terrain(65, 2000.0);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) = static_cast<float>(40.0 * std::sin(i / 5.0) * std::cos(j / 7.0));
  return terrain;
}

// What is made of a map's rows is all that is looked at, and much less than all there is.
TEST(RowsInView, HaveAllThatIsVisitedAndWhatTheMarginAsksFor) {
  const Heightfield terrain = waves();
  const View view =
      View({{560.0, 620.0, 42.0}, {1500.0, 800.0, 20.0}, 55.0}, 160, 90).over(terrain);
  const GroundGrid grid{{{600.0, 200.0}, 1000.0}, 501};
  const double margin_m = margin_in_view_m(view, grid.step_m()) + 2.0 * grid.step_m();
  const RowParts parts = rows_in_view(grid, terrain, view, margin_m);
  const FactorMap map(grid.samples, grid.square);
  std::vector<std::vector<int>> visited(parts.size());
  each_in_view(map, terrain, view, [&](int i, int j, const glm::dvec3&) {
    visited[static_cast<std::size_t>(j)].push_back(i);
  });
  std::size_t counted = 0;
  for (std::size_t j = 0; j < parts.size(); ++j) {
    std::vector<bool> counts(static_cast<std::size_t>(grid.samples));
    visit_row(parts[j], [&](int i) { counts[static_cast<std::size_t>(i)] = true; });
    counted += static_cast<std::size_t>(std::ranges::count(counts, true));
    for (int i = 0; i < grid.samples; ++i) {
      const glm::dvec3 at_m =
          above_ground(terrain, map.place_m(i, static_cast<int>(j)), /*height_m=*/0.0);
      EXPECT_EQ(counts[static_cast<std::size_t>(i)], view.may_see_ground(at_m, margin_m));
    }
    for (const int i : visited[j])
      for (int near = std::max(0, i - 2); near <= std::min(grid.samples - 1, i + 2); ++near)
        EXPECT_TRUE(counts[static_cast<std::size_t>(near)]) << near << ' ' << j;
  }
  EXPECT_TRUE(std::ranges::any_of(parts, [](const RowPart& part) { return part.size() > 1; }));
  EXPECT_GT(counted, 0U);
  EXPECT_LT(counted, parts.size() * parts.size() / 2);
}

TEST(RowsInView, AreMadeAsAllOfThemAre) {
  scene::Scene scene;
  scene.terrain.size_m = 2000.0;
  scene.terrain.samples = 65;
  scene.terrain.shape = scene::TerrainShape::mountain;
  scene.growth.cover = 0.6;
  const terrain::Ground land = terrain::make_ground(scene.terrain, scene.seed);
  ASSERT_TRUE(land.finer);
  const GroundGrid grid{{{600.0, 200.0}, 100.0}, 101};
  RowParts parts(101);
  for (int j = 20; j < 90; ++j) parts[static_cast<std::size_t>(j)] = {{j / 2, j - 5}, {j - 2, j}};
  const terrain::Surface all(land.heights_m, land.finer.get(), grid);
  const terrain::Surface some(land.heights_m, land.finer.get(), grid, {}, parts);
  const FactorMap growth = growth_map(scene, all), growth_of_some = growth_map(scene, some);
  const auto ground = [&](const terrain::Surface& surface) {
    return terrain::ground_reflectance(surface, {0.0, 0.6, 0.8}, scene.terrain, 9, growth);
  };
  const ColourMap whole = ground(all), part = ground(some);
  const terrain::GroundLight even{ColourMap(2, grid.square, glm::vec3(1.0F)),
                                  ColourMap(2, grid.square, glm::vec3(1.0F)),
                                  FactorMap(2, grid.square, 1.0F)};
  const ColourMap light = all.lit(even, {0.0, 0.6, 0.8}).sun;
  const ColourMap light_of_some = some.lit(even, {0.0, 0.6, 0.8}).sun;
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i) {
      const bool counts = j >= 20 && j < 90 && ((i >= j / 2 && i < j - 5) || (i >= j - 2 && i < j));
      EXPECT_EQ(growth_of_some.at(i, j), counts ? growth.at(i, j) : 0.0F);
      EXPECT_EQ(part.at(i, j), counts ? whole.at(i, j) : glm::vec3(0.0F));
      EXPECT_EQ(light_of_some.at(i, j), counts ? light.at(i, j) : glm::vec3(0.0F));
    }
}

}  // namespace
}  // namespace wold::place
