#include "meadow/bent_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/film_parts.h"
#include "support/grown.h"

namespace wold::meadow {
namespace {

/// A gust over blades before the camera, on a slope.
scene::Scene gusty_scene() {
  scene::Scene scene;
  scene.terrain.size_m = 12.0;
  scene.terrain.samples = 65;
  scene.terrain.hill_height_m = 2.0;
  scene.film.frame_seconds = 1.0 / 24.0;
  scene.ageing.frames = {0.1, 0.1, 0.1};
  scene.wind = {.heading_deg = 60.0,
                .speed_m_s = 9.0,
                .turbulence = 0.3,
                .grass = scene::GrassMotion::waving};
  scene.camera.eye_m = {6.0, 2.0};
  scene.camera.target_m = {6.0, 8.0};
  scene.render.grass = scene::GrassForm::blades;
  return scene;
}

struct Cells {
  std::vector<CellChoice> sheared, bent;
};

Cells cells_of(const scene::Scene& scene) {
  const place::Site site = test::site_of(scene);
  const FrameGrass now = frame_grass(scene, site, 2);
  Cells cells;
  cells.sheared =
      choose_cells(scene, site.terrain, test::grown(scene), *site.mixtures, *site.withering, now);
  cells.bent = cells.sheared;
  bend_blades(scene, site.terrain, now.frame, cells.bent);
  return cells;
}

bool is_bent(const CellChoice& cell) { return !cell.bend.is_none(); }

// A straight blade's tip is where the lean had put it, its foot where it was, its middle behind.
void expect_tips_where_the_lean_puts_them(const Cells& cells) {
  ASSERT_GT(std::ranges::count_if(cells.bent, is_bent), 20);
  for (std::size_t i = 0; i < cells.bent.size(); ++i)
    for (std::size_t k = 0; k < cells.bent[i].parts.size(); ++k) {
      const glm::dmat4& was = cells.sheared[i].parts[k].world_from_cell;
      const glm::dmat4& is = cells.bent[i].parts[k].world_from_cell;
      const glm::dvec2 lean = grass::tip_lean(cells.bent[i].bend);
      EXPECT_LT(glm::distance(is * glm::dvec4(0.3 * lean, 0.3, 1), was * glm::dvec4(0, 0, 0.3, 1)),
                1e-9);
      EXPECT_EQ(is[3], was[3]);
      if (is_bent(cells.bent[i])) {
        EXPECT_LT(glm::length(glm::dvec2(is[2])), glm::length(glm::dvec2(was[2])));
      }
    }
}

TEST(BentBlades, HaveTheirTipsWhereTheLeanPutsThem) {
  expect_tips_where_the_lean_puts_them(cells_of(gusty_scene()));
}

TEST(BentBlades, HaveThemThereInShrubsOfAnySize) {
  scene::Scene scene = gusty_scene();
  scene.species.resize(2);
  scene.species[1].plant.crown_m = 0.4;
  scene.species[1].habitat.cover = 0.5;
  const Cells cells = cells_of(scene);
  ASSERT_GT(
      std::ranges::count_if(
          cells.bent, [](const CellChoice& cell) { return cell.beside_cell && is_bent(cell); }),
      20);
  expect_tips_where_the_lean_puts_them(cells);
}

TEST(BentBlades, AreNeitherVolumesNorPointsNorStill) {
  const auto bent = [](const scene::Scene& scene) {
    return std::ranges::count_if(cells_of(scene).bent, is_bent);
  };
  scene::Scene scene = gusty_scene();
  scene.render.size_px = {160, 90};
  EXPECT_GT(bent(scene), 0);
  scene.render.grass = scene::GrassForm::points;
  EXPECT_EQ(bent(scene), 0);
  scene.render.grass = scene::GrassForm::texels;
  EXPECT_EQ(bent(scene), 0);
  scene.render.grass = scene::GrassForm::blades;
  scene.wind.grass = scene::GrassMotion::still;
  EXPECT_EQ(bent(scene), 0);
}

// The farthest that the shape of a cantilever is from the line to its tip, over half the way to the
// next state.
TEST(BentBlades, AreNowhereOffByAPixel) {
  double off = 0.0;
  for (double s = 0.0; s <= 1.0; s += 0.001)
    off = std::max(off, s - (6.0 - 4.0 * s + s * s) * s * s / 3.0);
  constexpr double height_m = 0.4;
  for (const double pixels_per_m : {20.0, 40.0, 60.0, 100.0, 200.0}) {
    const int steps = steps_apart(height_m, pixels_per_m);
    const double half_rad = std::sqrt(0.5) * steps * grass::BladeBend::step_rad;
    const double off_px = off * half_rad * height_m * pixels_per_m;
    if (steps != 1) {
      EXPECT_LE(off_px, 0.7) << pixels_per_m;
    }
    if (steps > 0 && steps < 8) {  // twice as far apart would be too far
      EXPECT_GT(2.0 * off_px, 0.7) << pixels_per_m;
    }
  }
  EXPECT_EQ(steps_apart(height_m, 1000.0), 1);
  EXPECT_EQ(steps_apart(height_m, 5.0), 0);
}

}  // namespace
}  // namespace wold::meadow
