#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/colour.h"
#include "film/assemble.h"
#include "film/exporters.h"
#include "meadow/far_field.h"
#include "place/ground_grids.h"
#include "support/film_parts.h"
#include "support/no_grass.h"
#include "support/sanitized.h"
#include "support/sees_ground.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

/// Terrains with more cells than can be laid: a window of cells, finer pictures of the ground about
/// the camera, snow in tiled pictures.
namespace wold::film {
namespace {

/// Level ground, seen by an eye that has nothing before it: no grass is painted, no haze shows.
scene::Scene plain(double size_m) {
  scene::Scene scene;
  scene.terrain.size_m = size_m;
  scene.terrain.samples = 129;
  scene.terrain.hill_height_m = 0.0;
  scene.terrain.relief_m = 0.0;
  scene.camera.eye_m = {size_m / 2.0, size_m / 2.0};
  scene.camera.target_m = {size_m / 2.0, size_m / 2.0 + 20.0};
  scene.render.size_px = {64, 36};
  scene.growth.cover = 0.0;
  scene.grass.far_field_below_pixels = 0.0;
  scene.sky.visual_range_m = 1e6;
  return scene;
}

/// A mountain of 900 m on 6 km, looked at from there.
scene::Scene mountain_from(const std::array<double, 2>& eye_m) {
  scene::Scene scene = plain(6000.0);
  scene.terrain.shape = scene::TerrainShape::mountain;
  scene.terrain.hill_height_m = 900.0;
  scene.camera.eye_m = eye_m;
  scene.camera.target_m = {3100.0, 3000.0};
  return scene;
}

TEST(CellWindow, IsTheWholeTerrainWhereThatFits) {
  scene::Scene scene;
  for (const double size_m : {42.0, 100.1, 120.0}) {
    scene.terrain.size_m = size_m;
    const place::CellWindow window(scene);
    EXPECT_FALSE(place::is_large(scene));
    EXPECT_EQ(window.first, glm::ivec2(0));
    EXPECT_EQ(window.per_side, place::cells_per_side(scene));
    EXPECT_EQ(window.square.corner_m, glm::dvec2(0.0));
    EXPECT_EQ(window.square.size_m, size_m);
    EXPECT_EQ(window.outside_fraction({0.0, size_m}), 0.0);
    EXPECT_TRUE(place::detail_grids(scene, {{1, 1, 1}, {1, 2, 1}, 60.0}).empty());
  }
}

// A little larger than what is not large: the window ends with the terrain.
TEST(CellWindow, LiesOnTheTerrain) {
  scene::Scene scene = plain(150.0);
  for (const double at_m : {1.0, 75.0, 149.0}) {
    scene.camera.eye_m = {at_m, at_m};
    const place::CellWindow window(scene);
    EXPECT_TRUE(place::is_large(scene));
    EXPECT_GE(window.first.x, 0);
    EXPECT_GT(window.per_side, 50);
    EXPECT_LE(window.first.x + window.per_side, place::cells_per_side(scene));
  }
}

TEST(CellWindow, HoldsAllGrassThatStandsAboutTheCamera) {
  scene::Scene scene = plain(50e3);
  scene.growth.cover = 1.0;
  scene.grass.far_field_below_pixels = 1.2;
  scene.camera.eye_m = {20e3, 10.0};  // at the southern border
  scene.camera.eye_end = {20030.0, 10.0, 1.6};
  const place::CellWindow window(scene);
  EXPECT_LE(window.per_side, 2000);
  EXPECT_EQ(window.first.y, 0);
  const double reach_m = place::farthest_standing_m(scene);
  for (const glm::dvec2 at_m : {glm::dvec2(20e3, 0.0), glm::dvec2(20e3 - reach_m, 10.0),
                                glm::dvec2(20030.0 + reach_m, 10.0)})
    EXPECT_EQ(window.outside_fraction(at_m), 0.0) << at_m.x;
  EXPECT_EQ(window.outside_fraction({20e3, window.square.size_m + 0.1}), 1.0);
  EXPECT_EQ(window.outside_fraction({window.square.corner_m.x - 0.1, 1.0}), 1.0);
}

// A camera that would see farther than there are cells: grass thins out towards their border.
TEST(CellWindow, GrassIsPaintedBeyondIt) {
  scene::Scene scene = plain(4000.0);  // far_field_below_pixels 0: all grass stands
  const Heightfield flat(17, 4000.0);
  const place::View view(place::resolved_camera(scene.camera, flat, 0.0), 64, 36);
  const place::CellWindow window(scene);
  ASSERT_EQ(window.per_side, 2000);
  double before = 0.0;
  for (double y_m = 2000.0; y_m < 4000.0; y_m += 5.0) {
    const double fraction = meadow::far_fraction(scene.grass, window, view, {2000.0, y_m, 0.0});
    EXPECT_GE(fraction, before);
    EXPECT_LT(fraction - before, 0.2);
    before = fraction;
  }
  EXPECT_EQ(meadow::far_fraction(scene.grass, window, view, {2000.0, 2500.0, 0.0}), 0.0);
  EXPECT_EQ(before, 1.0);
}

TEST(GroundDetails, AreNestedAndMoveByWholeSteps) {
  const scene::Scene scene = plain(100e3);
  landscape::Camera camera{{50e3, 50e3, 2.0}, {50.3e3, 51e3, 2.0}, 60.0};
  const auto grids = place::detail_grids(scene, camera);
  ASSERT_GE(grids.size(), 4U);
  EXPECT_LE(grids.back().step_m(), 0.01);
  GroundGrid before = place::whole_grid(scene);
  for (const GroundGrid& grid : grids) {
    EXPECT_TRUE(before.square.contains(grid.square.corner_m));
    EXPECT_TRUE(before.square.contains(grid.square.corner_m + grid.square.size_m));
    EXPECT_TRUE(grid.square.contains(glm::dvec2(camera.eye_m)));
    before = grid;
  }
  camera.eye_m.x += 123.4;
  camera.target_m.x += 123.4;
  const auto moved = place::detail_grids(scene, camera);
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const glm::dvec2 steps =
        (moved[k].square.corner_m - grids[k].square.corner_m) / grids[k].step_m();
    EXPECT_NEAR(steps.x, std::round(steps.x), 1e-3);
    EXPECT_NEAR(steps.y, std::round(steps.y), 1e-3);
  }
}

/// Whether a picture of the ground shows a place alone: no finer one has replaced it.
bool shows_alone(const landscape::Landscape& landscape, std::size_t detail,
                 const glm::dvec2& at_m) {
  if (detail + 1 >= landscape.ground_details.size()) return true;
  const landscape::GroundDetail& finer = landscape.ground_details[detail + 1];
  const double border_m = landscape::soft_border_m(landscape.ground_details[detail].map, finer);
  const Square replaced{finer.corner_m + border_m, finer.map.size_m() - 2.0 * border_m};
  return !replaced.contains(at_m);
}

/// Mean over a square of a picture, at many places.
glm::dvec3 mean_over(const ColourMap& map, const Square& square) {
  constexpr int places = 400;
  glm::dvec3 sum(0.0);
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i) {
      const glm::dvec2 at_m = square.corner_m + (glm::dvec2(i, j) + 0.5) * (square.size_m / places);
      sum += glm::dvec3(map.sample(at_m.x, at_m.y)) / (1.0 * places * places);
    }
  return sum;
}

// All that the camera sees is as fine as its picture can show it; much of what hills hide is left
// to the coarsest one.
TEST(GroundDetails, AreMadeWhereTheCameraSeesThem) {
  const test::TemporaryFolder folder("seen_details");
  const scene::Scene scene = mountain_from({3000.0, 1500.0});
  const landscape::Landscape landscape =
      assemble(scene, test::site_of(scene, folder.path()), test::grass_of(scene, 1), {},
               test::no_grass(), needs_of({}));
  const place::View view(landscape.camera, scene.render.size_px[0], scene.render.size_px[1]);
  int seen = 0, hidden = 0, left = 0;
  for (std::size_t k = 0; k < landscape.ground_details.size(); ++k) {
    const landscape::GroundDetail& detail = landscape.ground_details[k];
    for (int j = 0; j < detail.map.samples(); ++j)
      for (int i = 0; i < detail.map.samples(); ++i) {
        const glm::dvec2 at_m = detail.corner_m + detail.map.place_m(i, j);
        if (!landscape.terrain.square().contains(at_m) || !shows_alone(landscape, k, at_m) ||
            !view.may_see(place::above_ground(landscape.terrain, at_m, 0.0), 0.0))
          continue;
        const bool coarse = detail.map.at(i, j) == landscape.ground.sample(at_m.x, at_m.y);
        if (test::sees_ground(landscape.terrain, landscape.camera.eye_m, at_m, /*step_m=*/2.0)) {
          ++seen;
          EXPECT_FALSE(coarse) << at_m.x << ' ' << at_m.y;
        } else {
          ++hidden;
          left += coarse ? 1 : 0;
        }
      }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 1000);
  EXPECT_GT(left, hidden / 3);
}

// Light and look of the ground are as fine where the camera sees it as if all of it were. Elsewhere
// they come from a coarser map, on the mean the same.
TEST(GroundDetails, LeaveTheWholeAsFineWhereItIsSeen) {
  const test::TemporaryFolder folder("seen_whole");
  scene::Scene scene = mountain_from({3000.0, 200.0});
  scene.terrain.relief_m = 20.0;
  scene.render.size_px = {192, 108};
  const place::Site site = test::site_of(scene, folder.path());
  const GroundGrid grid = place::whole_grid(scene);
  const place::GroundPart all =
      place::ground_part(scene, site, grid, whole_rows(grid.samples), /*snow_m=*/{});
  const landscape::Camera camera = place::camera_of_frame(scene, site.terrain, 1);
  const place::View view(camera, scene.render.size_px[0], scene.render.size_px[1]);
  int seen = 0;
  glm::dvec3 mean(0.0), mean_of_all(0.0);
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i) {
      const glm::dvec2 at_m = site.ground_reflectance.place_m(i, j);
      mean += glm::dvec3(site.light.sun.at(i, j));
      mean_of_all += glm::dvec3(all.light.sun.at(i, j));
      if (!view.may_see(place::above_ground(site.terrain, at_m, 0.0), 0.0) ||
          !test::sees_ground(site.terrain, camera.eye_m, at_m, /*step_m=*/10.0))
        continue;
      ++seen;
      ASSERT_EQ(site.ground_reflectance.at(i, j), all.reflectance.at(i, j)) << i << ' ' << j;
      ASSERT_EQ(site.light.sun.at(i, j), all.light.sun.at(i, j)) << i << ' ' << j;
      ASSERT_EQ(site.light.sky.at(i, j), all.light.sky.at(i, j)) << i << ' ' << j;
    }
  EXPECT_GT(seen, 500);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], mean_of_all[c], 0.03 * mean_of_all[c]);
}

/// The plain with so much snow, mm of water.
landscape::Landscape snowed_on(double water_mm, const std::filesystem::path& folder) {
  scene::Scene scene = plain(2000.0);
  scene.snow_cover.initial_mm = water_mm;
  scene.weather.temperature_c = -1.0;
  return assemble(scene, test::site_of(scene, folder), test::grass_of(scene, 1), {},
                  test::no_grass(), needs_of({}));
}

// Both pictures are of the same ground, bare or white: the coarse one shows the mean of what the
// fine one has.
TEST(GroundDetails, AgreeWithTheWholeMap) {
  const test::TemporaryFolder folder("ground_details");
  for (const double water_mm : {0.0, 30.0}) {
    const landscape::Landscape landscape = snowed_on(water_mm, folder.path());
    ASSERT_GE(landscape.ground_details.size(), 4U);
    for (std::size_t k = 0; k < 2; ++k) {  // larger than many features
      const landscape::GroundDetail& detail = landscape.ground_details[k];
      const glm::dvec3 fine = mean_over(detail.map, detail.map.square());
      const glm::dvec3 coarse = mean_over(landscape.ground, {detail.corner_m, detail.map.size_m()});
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(fine[c], coarse[c], 0.01 * coarse[c]) << k;
    }
  }
}

// Where little snow lies all pictures have patches of it, each as small as it can show; where a
// picture is hardly wider than the smallest patches it may have one alone.
TEST(GroundDetails, ShowPatchesOfSnow) {
  const test::TemporaryFolder folder("snow_patches");
  const landscape::Landscape landscape = snowed_on(1.5, folder.path());
  const double smallest_m = scene::SnowCover{}.feature_m;
  const place::View view(landscape.camera, landscape.width_px, landscape.height_px);
  for (const landscape::GroundDetail& detail : landscape.ground_details) {
    const double side_m = detail.map.size_m();
    const glm::dvec3 middle_m(detail.corner_m + 0.5 * side_m, 0.0);
    if (side_m < 2.0 * smallest_m || !view.may_see(middle_m, 0.5 * side_m)) continue;
    const auto [min, max] = std::ranges::minmax(detail.map.values(), {},
                                                [](const glm::vec3& value) { return value.g; });
    EXPECT_GT(max.g, 3.0F * min.g) << detail.map.size_m();
  }
}

/// Light on the grass of 400 m, whose whole map has steps of decimetres.
landscape::Landscape lit_grass(double unevenness, const std::filesystem::path& folder) {
  scene::Scene scene = plain(400.0);
  scene.growth.cover = 1.0;
  scene.grass.patch_m = 1.2;
  scene.grass.far_field_below_pixels = 1.2;
  scene.grass.unevenness = unevenness;
  scene.ageing.pigment_spread = 0.0;
  scene.render.size_px = {320, 180};
  const place::Site site = test::site_of(scene, folder);
  const std::vector<meadow::CellChoice> cells =
      meadow::choose_cells(scene, site.terrain, place::growth_of_cells(site), *site.mixtures,
                           *site.withering, test::grass_of(scene, 1));
  const landscape::Landscape any = test::synthetic_landscape({.volumes = 1}, folder / "texels");
  PatchLookup lookup = test::no_grass();
  lookup.far = [look = meadow::PatchAppearance(any.volumes)](auto&&...) { return look; };
  return assemble(scene, site, test::grass_of(scene, 1), cells, lookup, needs_of({}));
}

/// Of finer light over that of the whole map, where the camera sees it: in the mean, and how far
/// single values are from 1.
glm::dvec2 mean_and_spread(const landscape::Landscape& landscape, const ColourMap& detail) {
  const place::View view(landscape.camera, landscape.width_px, landscape.height_px);
  double fines = 0.0, coarses = 0.0, squares = 0.0, count = 0.0;
  for (int j = 0; j < detail.samples(); ++j)
    for (int i = 0; i < detail.samples(); ++i) {
      const glm::dvec2 at_m = detail.place_m(i, j);
      const float fine = detail.at(i, j).g, coarse = landscape.light.sample(at_m.x, at_m.y).g;
      if (!view.may_see(place::above_ground(landscape.terrain, at_m, 0.0), -1.0)) continue;
      fines += fine;
      coarses += coarse;
      squares += double{(fine / coarse - 1.0F) * (fine / coarse - 1.0F)};
      ++count;
    }
  return {fines / coarses, std::sqrt(squares / count)};
}

// On an even sward there is nothing that a coarse map cannot show.
TEST(LightDetails, ShowTheTussocksThatTheWholeMapIsTooCoarseFor) {
  const test::TemporaryFolder folder("light_details");
  const landscape::Landscape uneven = lit_grass(0.35, folder.path());
  const landscape::Landscape even = lit_grass(0.0, folder.path());
  ASSERT_FALSE(uneven.light_details.empty());
  for (std::size_t k = 0; k < uneven.light_details.size(); ++k) {
    const glm::dvec2 of_uneven = mean_and_spread(uneven, uneven.light_details[k]);
    EXPECT_NEAR(of_uneven[0], 1.0, 0.01) << k;
    EXPECT_GT(of_uneven[1], 0.02) << k;
    EXPECT_LT(mean_and_spread(even, even.light_details[k])[1], 0.1 * of_uneven[1]) << k;
  }
}

double peak_memory_mb() {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// Nothing is paid for the area: 100 km take what 2 km do.
TEST(LargeTerrain, OfAHundredKilometresTakesBoundedMemory) {
  const test::TemporaryFolder folder("large_terrain");
  scene::Scene scene = plain(100e3);
  scene.terrain.shape = scene::TerrainShape::mountain;
  scene.terrain.samples = 257;
  scene.terrain.hill_height_m = 3000.0;
  scene.terrain.relief_m = 30.0;
  scene.terrain.relief_feature_m = 5000.0;
  scene.camera.eye_m = {50e3, 2e3};
  scene.camera.target_m = {50e3, 10e3};
  scene.snow_cover.initial_mm = 40.0;
  scene.weather.temperature_c = 7.0;
  scene.weather.earlier_h = 120.0;           // all has melted below 670 m
  scene.grass.far_field_below_pixels = 0.0;  // as many cells as there can be
  const double before_mb = peak_memory_mb();
  const place::Site site = test::site_of(scene, folder.path());
  const std::vector<meadow::CellChoice> cells =
      meadow::choose_cells(scene, site.terrain, place::growth_of_cells(site), *site.mixtures,
                           *site.withering, test::grass_of(scene, 1));
  const landscape::Landscape landscape =
      assemble(scene, site, test::grass_of(scene, 1), cells, test::no_grass(), needs_of({}));
  const double max_mb = test::sanitized ? 1400.0 : 700.0;  // with their notes on what is allocated
  EXPECT_LT(peak_memory_mb() - before_mb, max_mb);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "ground.tif"));

  // Below the snow line the ground is bare, high up it is white.
  double low = 0.0, high = 0.0;
  int lows = 0, highs = 0;
  for (int j = 0; j < landscape.ground.samples(); ++j)
    for (int i = 0; i < landscape.ground.samples(); ++i) {
      const glm::dvec2 at_m = landscape.ground.place_m(i, j);
      const double height_m = site.terrain.sample(at_m.x, at_m.y);
      if (height_m < 200.0) low += luminance(landscape.ground.at(i, j)), ++lows;
      if (height_m > 1200.0) high += luminance(landscape.ground.at(i, j)), ++highs;
    }
  ASSERT_GT(lows, 100);
  ASSERT_GT(highs, 100);
  EXPECT_GT(high / highs, 3.0 * low / lows);
}

}  // namespace
}  // namespace wold::film
