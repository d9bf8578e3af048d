#include "cloud/procedural_texture.h"

#include <gtest/gtest.h>

#include "core/noise.h"

namespace wold::cloud {
namespace {

class Kinds : public testing::TestWithParam<scene::CloudKind> {};

TEST_P(Kinds, TileToTheBit) {
  Recipe recipe = recipe_of(GetParam());
  recipe.warp = 0.0;  // a displaced place plus one is rounded, a place that is exact is not
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 place(i * 37 % 256 / 256.0, i * 91 % 256 / 256.0);
    const double field = procedural_field_at(recipe, place, 5);
    EXPECT_EQ(procedural_field_at(recipe, place + glm::dvec2(1.0, 0.0), 5), field);
    EXPECT_EQ(procedural_field_at(recipe, place + glm::dvec2(-3.0, 2.0), 5), field);
  }
}

TEST_P(Kinds, HaveNoSeam) {
  const PeriodicMap<float> field = procedural_field(recipe_of(GetParam()), 128, 11);
  double inside = 0.0, across_x = 0.0, across_y = 0.0;
  for (int i = 0; i < 128; ++i) {
    for (int j = 1; j < 128; ++j) inside += std::abs(field.at(j, i) - field.at(j - 1, i)) / 127.0;
    across_x += std::abs(field.at(0, i) - field.at(127, i));
    across_y += std::abs(field.at(i, 0) - field.at(i, 127));
  }
  EXPECT_LT(across_x, 2.0 * inside);
  EXPECT_LT(across_y, 8.0 * inside);  // fibres and rolls change faster to the north
  EXPECT_NE(field.values(), procedural_field(recipe_of(GetParam()), 128, 12).values());
}

INSTANTIATE_TEST_SUITE_P(Clouds, Kinds,
                         testing::Values(scene::CloudKind::stratus, scene::CloudKind::stratocumulus,
                                         scene::CloudKind::cumulus, scene::CloudKind::cirrus));

TEST(CellNoise, RepeatsExactlyAndIsADistance) {
  const glm::ivec2 period(3, 5);
  double largest_slope = 0.0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 at(i * 53 % 192 / 64.0, i * 29 % 320 / 64.0);
    const double distance = cell_noise(at, 9, period);
    EXPECT_EQ(cell_noise(at + glm::dvec2(3.0, -10.0), 9, period), distance);
    EXPECT_GE(distance, 0.0);
    EXPECT_LT(distance, 1.5);
    const double beside = cell_noise(at + glm::dvec2(1e-6, 0.0), 9, period);
    largest_slope = std::max(largest_slope, std::abs(beside - distance) / 1e-6);
  }
  EXPECT_NEAR(largest_slope, 1.0, 0.01);  // a distance changes by no more than one walks
}

}  // namespace
}  // namespace wold::cloud
