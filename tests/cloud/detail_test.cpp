#include "cloud/detail.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cloud/clouds.h"
#include "cloud/procedural_texture.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

constexpr double cell_m = 4000.0;
const glm::dvec2 period_m(32000.0, 24000.0);

/// Octaves of 62.5, 31.25 and 15.625 m are too fine for 128 pixels of 31.25 m.
Recipe noise(double gain) {
  Recipe recipe;
  recipe.masses = {2.0, {4, 4}, 7, gain};
  return recipe;
}

template <class Value>
double root_mean_square(const Value& value) {
  constexpr int places = 40000;
  double sum = 0.0;
  for (std::uint64_t i = 0; i < places; ++i) {
    const double x =
        value(glm::dvec2(5000.0 * random_uniform({i, 0}), 5000.0 * random_uniform({i, 1})));
    sum += x * x;
  }
  return std::sqrt(sum / places);
}

TEST(Detail, IsTheOctavesThatTheMapLeavesOut) {
  const Recipe recipe = noise(0.5);
  EXPECT_EQ(octaves_in_map(recipe.masses, 128), 4);  // 32 features of 4 pixels, not 64 of 2
  EXPECT_EQ(octaves_in_map(recipe.masses, 2), 1);
  EXPECT_EQ(octaves_in_map(recipe.masses, 100000), 7);
  const Detail detail(recipe, 128, cell_m, period_m, 3);
  const auto field = [&](double footprint_m) {
    return root_mean_square([&](const glm::dvec2& at) { return detail.at(at, footprint_m); });
  };
  // Octaves of height 2 * 0.5^4 and on, of deviation 1 each.
  EXPECT_NEAR(field(0.0), 2.0 / 16 * std::sqrt(1.0 + 0.25 + 0.0625), 0.01);
  EXPECT_NEAR(field(31.25), 2.0 / 16, 0.01);  // only the coarsest is wider than this
  EXPECT_EQ(field(62.5), 0.0);
  const Detail none(recipe, 1024, cell_m, period_m, 3);
  EXPECT_EQ(none.at({123.0, 456.0}, 0.0), 0.0);
}

TEST(Detail, RepeatsWithItsLayer) {
  const Detail detail(recipe_of(scene::CloudKind::cirrus), 64, cell_m, period_m, 3);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 at(i * 317.0, i * 211.0);
    EXPECT_NEAR(detail.at(at + period_m * glm::dvec2(2.0, -1.0), 0.0), detail.at(at, 0.0), 1e-6);
  }
}

// A fine map holds what a coarse one leaves to its detail.
TEST(Detail, KeepsTheCoverOfTheSky) {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].cover = 0.4;
  const double pixel_m = 62.5;
  const CloudState state = Clouds(scene, pixel_m).at(0.0);
  const Layer& layer = *state.layers[0].layer;
  const LayerMap& ranks = state.layers[0].map->ranks;
  int covered = 0, changed = 0;
  constexpr int places = 40000;
  for (std::uint64_t i = 0; i < places; ++i) {
    const glm::dvec2 at(random_uniform({i, 2}), random_uniform({i, 3}));
    const double rank = ranks.sample(at.x, at.y) / 65535.0;
    const double rise = rank_rise(layer, rank, layer.detail.at(at * layer.period_m, 0.0));
    covered += rank + rise > 0.6;
    changed += (rank > 0.6) != (rank + rise > 0.6);
  }
  EXPECT_NEAR(covered / double{places}, 0.4, 0.02);
  EXPECT_GT(changed, places / 50);
}

}  // namespace
}  // namespace wold::cloud
