#include "meadow/sward.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/species.h"

namespace wold::meadow {
namespace {

scene::Scene wide() {
  scene::Scene scene;
  scene.terrain.size_m = 4000.0;
  return scene;
}

/// Places far and near, of no lattice.
std::vector<glm::dvec2> places() {
  std::vector<glm::dvec2> all;
  for (double x = 0.3; x < 4000.0; x += 17.37)
    for (double y = 0.7; y < 4000.0; y += 17.91) all.emplace_back(x, y);
  return all;
}

double mean_square(const Sward& sward) {
  double sum = 0.0;
  for (const glm::dvec2& at_m : places()) sum += sward.at(at_m).height * sward.at(at_m).height;
  return sum / static_cast<double>(places().size());
}

TEST(Sward, DiffersAsMuchAsItIsAskedTo) {
  scene::Scene scene = wide();
  EXPECT_NEAR(std::sqrt(mean_square(Sward(scene, 0.01))), 0.35, 0.03);
  scene.grass.unevenness = 0.1;
  EXPECT_NEAR(std::sqrt(mean_square(Sward(scene, 0.01))), 0.1, 0.01);
}

// Hutchings 1991: variation with scales of less than 1 to 2 m dominates.
TEST(Sward, VariesMostWithinTwoMetres) {
  const double all = mean_square(Sward(wide(), 0.01));
  EXPECT_LT(mean_square(Sward(wide(), 2.0)), 0.5 * all);
  EXPECT_GT(mean_square(Sward(wide(), 2.0)), 0.1 * all);
  EXPECT_EQ(mean_square(Sward(wide(), 12.0)), 0.0);
}

TEST(Sward, IsShownInAPlaceAsAMapOfThatStepShowsIt) {
  const Sward fine(wide(), 0.01), coarse(wide(), 0.7);
  for (const glm::dvec2& at_m : places()) {
    ASSERT_EQ(fine.at(at_m, 0.7).height, coarse.at(at_m).height);
    ASSERT_EQ(fine.at(at_m, 0.7).ascent, coarse.at(at_m, 0.3).ascent);
  }
}

TEST(Sward, IsRougherInSomePlacesThanInOthers) {
  const Sward sward(wide(), 0.01);
  std::vector<double> roughness;
  for (double x = 100.0; x < 4000.0; x += 300.0)
    for (double y = 100.0; y < 4000.0; y += 300.0) {
      double sum = 0.0;
      for (int i = 0; i < 100; ++i) {
        const double height = sward.at({x + 0.93 * (i % 10), y + 0.93 * (i / 10)}).height;
        sum += height * height / 100.0;
      }
      roughness.push_back(std::sqrt(sum));
    }
  std::ranges::sort(roughness);
  EXPECT_GT(roughness[roughness.size() * 9 / 10], 2.0 * roughness[roughness.size() / 10]);
}

TEST(Sward, AscendsAsItsHeightDoes) {
  const Sward sward(wide(), 0.01);
  const double height_m = scene::mean_grass(wide()).height_m;
  constexpr double step_m = 1e-3;
  double apart = 0.0, steep = 0.0;
  for (const glm::dvec2& at_m : places()) {
    const double rise = height_m *
                        (sward.at(at_m + glm::dvec2(step_m, 0.0)).height -
                         sward.at(at_m - glm::dvec2(step_m, 0.0)).height) /
                        (2.0 * step_m);
    const double ascent = sward.at(at_m).ascent.x;
    apart += (rise - ascent) * (rise - ascent);
    steep += ascent * ascent;
  }
  EXPECT_LT(std::sqrt(apart / steep), 0.02);
}

/// Slope by slope: what the sun gives to one flank of a tussock it takes from the other.
TEST(Sward, FlanksFaceTheSunOrTurnFromIt) {
  const Sward sward(wide(), 0.01);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dvec3 east = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
  const glm::dvec3 west = glm::normalize(glm::dvec3(-1.0, 0.0, 1.0));
  int seen = 0;
  for (const glm::dvec2& at_m : places()) {
    const double of_sky = Sward::light(sward.at(at_m), up, east, /*by_sun=*/0.0);
    const double in_east = Sward::light(sward.at(at_m), up, east, 0.8);
    const double in_west = Sward::light(sward.at(at_m), up, west, 0.8);
    if (std::max({of_sky, in_east, in_west}) >= 1.7 || std::min(in_east, in_west) <= 0.35) continue;
    ++seen;
    EXPECT_NEAR(in_east + in_west, 2.0 * of_sky, 1e-9);
    EXPECT_EQ(in_east > in_west, sward.at(at_m).ascent.x < 0.0);
    EXPECT_EQ(of_sky > 1.0, sward.at(at_m).height > 0.0);
  }
  EXPECT_GT(seen, static_cast<int>(0.8 * static_cast<double>(places().size())));
}

// Far away, where no tussock is seen, a meadow is as bright as a level one.
TEST(Sward, TakesNoLightOnTheMean) {
  const Sward sward(wide(), 0.01);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.2, -0.3, 1.0));
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-0.8, -0.4, 0.6));
  double sum = 0.0;
  for (const glm::dvec2& at_m : places()) sum += Sward::light(sward.at(at_m), up, to_sun, 0.8);
  EXPECT_NEAR(sum / static_cast<double>(places().size()), 1.0, 0.02);
}

// A low sun lights no flank evenly, but a level top as if there were none.
TEST(Sward, IsALevelTopWithoutUnevennessUnderAnySun) {
  scene::Scene scene = wide();
  scene.grass.unevenness = 0.0;
  const Sward sward(scene, 0.01);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  for (const double height : {-0.05, 0.02, 0.08, 0.5})
    EXPECT_EQ(
        Sward::light(sward.at({7.0, 9.0}), up, glm::normalize(glm::dvec3(0.9, 0.4, height)), 0.8),
        1.0);
}

/// Cast shadow has no bright flanks.
TEST(Sward, MapHasTheSunsContrastWhereTheSunShines) {
  const Sward sward(wide(), 0.1);
  const Square square{{1000.0, 1000.0}, 40.0};
  terrain::GroundLight light{ColourMap(201, square, glm::vec3(0.8F)),
                             ColourMap(201, square, glm::vec3(0.2F)), FactorMap(201, square, 1.0F)};
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 100; ++i) light.sun.at(i, j) = glm::vec3(0.0F);
  const Heightfield level(2, 4000.0);
  const place::View from_above({{1020.0, 1020.0, 100.0}, {1020.0, 1020.1, 0.0}, 60.0}, 100, 100);
  const FactorMap map =
      sward_light_map(sward, light, glm::normalize(glm::dvec3(0.9, 0.0, 0.4)), level, from_above);
  double of_shade = 0.0, of_sun = 0.0;
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 100; ++i) {
      const double shade = map.at(i, j) - 1.0F, sun = map.at(200 - i, j) - 1.0F;
      of_shade += shade * shade;
      of_sun += sun * sun;
    }
  EXPECT_GT(of_shade, 0.0);
  EXPECT_GT(of_sun, 1.5 * of_shade);
}

}  // namespace
}  // namespace wold::meadow
