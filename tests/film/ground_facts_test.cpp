#include "film/ground_facts.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "film/exporters.h"
#include "meadow/cells.h"
#include "support/film_parts.h"
#include "support/no_grass.h"

namespace wold::film {
namespace {

/// Three frames of gusts over a small meadow.
scene::Scene windy_meadow() {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 65;
  scene.terrain.hill_height_m = 1.0;
  scene.grass.patch_m = 0.5;
  scene.camera.eye_m = {4.0, 0.5};
  scene.camera.target_m = {4.0, 6.0};
  scene.ageing.frames = {0.3, 0.3, 0.3};
  scene.film.frame_seconds = 0.25;
  scene.wind.grass = scene::GrassMotion::waving;
  scene.wind.speed_m_s = 8.0;
  return scene;
}

/// How each cell leans, by column and row.
std::map<std::pair<int, int>, glm::dvec2> leans_in(const scene::Scene& scene,
                                                   const place::Site& site, int frame) {
  const std::vector<meadow::CellChoice> cells =
      meadow::choose_cells(scene, site.terrain, site.growth, *site.mixtures, *site.withering,
                           meadow::frame_grass(scene, site, frame));
  std::map<std::pair<int, int>, glm::dvec2> leans;
  for (const meadow::CellChoice& cell : cells)
    leans[{cell.cell.x, cell.cell.y}] = glm::dvec2(cell.parts.front().world_from_cell[2]);
  return leans;
}

passes::GroundFacts facts_in(const scene::Scene& scene, const place::Site& site,
                             const meadow::FrameGrass& now) {
  const AssembledFrame assembled =
      assemble_frame(scene, site, now, {}, test::no_grass(), needs_of({}));
  return ground_facts(scene, site, now, assembled, test::no_grass());
}

TEST(GroundFacts, WavingGrassLeansOnAsItsCellsDo) {
  const scene::Scene scene = windy_meadow();
  const place::Site site = test::site_of(scene);
  for (const auto& [frame, from, to] : {std::tuple{1, 1, 2}, {2, 2, 3}, {3, 2, 3}}) {
    const meadow::FrameGrass now = meadow::frame_grass(scene, site, frame);
    const passes::GroundFacts facts = facts_in(scene, site, now);
    const auto before = leans_in(scene, site, from), after = leans_in(scene, site, to);
    double largest = 0.0;
    for (const auto& [cell, lean] : before) {
      if (!after.contains(cell)) continue;
      const glm::dvec2 more = facts.more_lean({cell.first, cell.second});
      ASSERT_LT(glm::distance(more, after.at(cell) - lean), 1e-9) << "frame " << frame;
      largest = std::max(largest, glm::length(more));
    }
    EXPECT_GT(largest, 0.005);
  }
}

TEST(GroundFacts, StillGrassLeansNoMore) {
  scene::Scene scene = windy_meadow();
  scene.wind.grass = scene::GrassMotion::still;
  const place::Site site = test::site_of(scene);
  const meadow::FrameGrass now = meadow::frame_grass(scene, site, 1);
  EXPECT_FALSE(facts_in(scene, site, now).more_lean);
}

// Stalks of 0.1 m x 1 mm with ten petals of 10 x 5 mm: six times the area of the stalk.
TEST(GroundFacts, FlowersCountWithTheirPetals) {
  scene::Scene scene = windy_meadow();
  scene.species.resize(2);
  scene.species[0].plant.height_m = 0.2;
  scene.species[0].plant.width_m = 0.004;
  scene.species[1].plant.height_m = 0.1;
  scene.species[1].plant.width_m = 0.001;
  scene.species[1].flower.petals = 10;
  scene.species[1].flower.length_m = 0.01;
  scene.species[1].flower.width_m = 0.005;
  const place::Site site = test::site_of(scene);
  const passes::GroundFacts facts = facts_in(scene, site, meadow::frame_grass(scene, site, 1));
  ASSERT_EQ(facts.mixtures.size(), 1U);
  EXPECT_NEAR(facts.mixtures[0][1], 6.0 / (6.0 + 8.0), 1e-9);
}

}  // namespace
}  // namespace wold::film
