#include "meadow/light_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "place/ground_grids.h"

namespace wold::meadow {
namespace {

/// So wide and seen with so many pixels that light on all of its grass has coarse steps.
scene::Scene wide() {
  scene::Scene scene;
  scene.terrain.size_m = 4000.0;
  scene.grass.patch_m = 0.6;
  scene.render.size_px = {1920, 1080};
  scene.camera.eye_m = {2000.0, 2000.0};
  return scene;
}

Heightfield flat() { return Heightfield(2, 4000.0); }

/// North of a place, as far as `count` cells; every `apart`-th of them.
std::vector<CellChoice> cells_north_of(const glm::dvec2& at_m, int count, int apart = 1) {
  std::vector<CellChoice> cells;
  for (int j = 0; j < count; j += apart)
    for (int i = -j; i <= j; i += apart) {
      CellChoice choice;
      choice.cell = glm::ivec2(at_m / 0.6) + glm::ivec2(i, j);
      cells.push_back(choice);
    }
  return cells;
}

TEST(LightGrids, GetFinerUntilTussocksShow) {
  const scene::Scene scene = wide();
  const double coarse_m = place::window_grid(scene).step_m();
  ASSERT_GT(coarse_m, 0.3);
  const auto grids =
      light_detail_grids(scene, cells_north_of({2000.0, 2000.0}, 700, 7), flat(), {2e3, 2e3, 0.0});
  ASSERT_EQ(grids.size(), 2U);
  EXPECT_NEAR(grids[0].step_m(), coarse_m / 3.0, 1e-9);
  EXPECT_NEAR(grids[1].step_m(), coarse_m / 9.0, 1e-9);
  EXPECT_LE(grids[1].step_m(), 0.1);
}

// Others take their light from coarser maps, and a map that held them would be too large.
TEST(LightGrids, HoldTheCellsWithinAThousandSteps) {
  const scene::Scene scene = wide();
  const glm::dvec2 eye_m(2000.0);
  const std::vector<CellChoice> cells = cells_north_of(eye_m, 700, 7);
  const auto grids = light_detail_grids(scene, cells, flat(), {eye_m, 0.0});
  ASSERT_EQ(grids.size(), 2U);
  for (const GroundGrid& grid : grids) {
    EXPECT_LT(grid.samples, 2200);
    EXPECT_GT(grid.samples, 900);
    for (const CellChoice& choice : cells) {
      const glm::dvec2 middle_m = (glm::dvec2(choice.cell) + 0.5) * 0.6;
      if (glm::distance(middle_m, eye_m) < 999.0 * grid.step_m()) {
        EXPECT_TRUE(grid.square.contains(middle_m - 1.0));
        EXPECT_TRUE(grid.square.contains(middle_m + 1.0));
      }
    }
  }
  EXPECT_TRUE(grids[0].square.contains(grids[1].square.corner_m));
}

// What is looked up between samples does not change while the eye moves.
TEST(LightGrids, LieOnWholeSteps) {
  const scene::Scene scene = wide();
  for (const double moved_m : {0.0, 1.7, 30.3}) {
    const glm::dvec2 eye_m(2000.0 + moved_m, 2000.0);
    const auto grids = light_detail_grids(scene, cells_north_of(eye_m, 300), flat(), {eye_m, 0.0});
    EXPECT_EQ(grids.size(), 2U);
    for (const GroundGrid& grid : grids) {
      const glm::dvec2 steps = grid.square.corner_m / grid.step_m();
      EXPECT_NEAR(steps.x, std::round(steps.x), 1e-6);
      EXPECT_NEAR(steps.y, std::round(steps.y), 1e-6);
    }
  }
}

// From high up all ground is far away.
TEST(LightGrids, AreFewerFromAbove) {
  const scene::Scene scene = wide();
  const auto cells = cells_north_of({2000.0, 2000.0}, 300, 5);
  EXPECT_EQ(light_detail_grids(scene, cells, flat(), {2e3, 2e3, 100.0}).size(), 1U);
  EXPECT_EQ(light_detail_grids(scene, cells, flat(), {2e3, 2e3, 300.0}).size(), 0U);
}

// Where two maps meet neither can show more than the other.
TEST(ShownSteps, AreNeverFinerThanTheMapThatReachesThere) {
  const scene::Scene scene = wide();
  const ShownSteps shown(scene, {2e3, 2e3, 10.0});
  const double coarse_m = place::window_grid(scene).step_m();
  for (const double step_m : light_detail_steps_m(scene)) {
    const double reach_m = light_detail_reach_steps * step_m;
    EXPECT_NEAR(shown.at({2e3 + reach_m, 2e3, 10.0}), 3.0 * step_m, 1e-9);
    EXPECT_NEAR(shown.at({2e3, 2e3, 10.0 - reach_m / 3.0}), step_m, 1e-9);
  }
  EXPECT_EQ(shown.at({2e3, 3900.0, 0.0}), coarse_m);
}

TEST(LightGrids, AreNoneWhereNoneIsNeeded) {
  scene::Scene scene = wide();
  EXPECT_TRUE(light_detail_grids(scene, {}, flat(), {2e3, 2e3, 0.0}).empty());
  EXPECT_TRUE(
      light_detail_grids(scene, cells_north_of({2000.0, 2000.0}, 9), flat(), {1000.0, 2000.0, 0.0})
          .empty());
  scene.terrain.size_m = 100.0;  // whose light has the finest steps anyway
  EXPECT_TRUE(light_detail_grids(scene, cells_north_of({50.0, 50.0}, 9), flat(), {50.0, 50.0, 0.0})
                  .empty());
}

}  // namespace
}  // namespace wold::meadow
