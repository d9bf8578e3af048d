#include "place/mixture_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/image.h"
#include "place/growth.h"
#include "scene/species.h"
#include "support/temporary_folder.h"

namespace wold::place {
namespace {

/// Two species on a square of 60 m: the first everywhere, the second where the test says.
scene::Scene two_species() {
  scene::Scene scene;
  scene.terrain.size_m = 60.0;
  scene.species.resize(2);
  return scene;
}

/// A plane that rises to the north.
Heightfield plane(double rise) {
  Heightfield terrain(121, 60.0);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) = static_cast<float>(rise * j * terrain.step_m());
  return terrain;
}

/// How much of a square of ground a species stands on.
double stands_on(const scene::Scene& scene, const MixtureField& field, int species,
                 const Square& square = {.size_m = 60.0}) {
  constexpr int places = 150;
  const std::vector<scene::Mixture> mixtures = scene::mixtures_of(scene);
  int found = 0;
  for (int k = 0; k < places * places; ++k) {
    const glm::dvec2 at_m =
        square.corner_m + (glm::dvec2(k % places, k / places) + 0.5) * (square.size_m / places);
    const scene::Mixture& here = mixtures.at(static_cast<std::size_t>(field.at(at_m)));
    found += std::ranges::count(here, species) > 0;
  }
  return found / (1.0 * places * places);
}

TEST(MixtureField, OfSpeciesThatGrowEverywhereIsTheFirstEverywhere) {
  const scene::Scene scene = two_species();
  const MixtureField field(scene, plane(0.3));
  EXPECT_EQ(field.present(), std::vector<int>{0});
  EXPECT_EQ(stands_on(scene, field, 0), 1.0);
  EXPECT_EQ(stands_on(scene, field, 1), 1.0);
}

// Patches of a size: the fraction of the ground is the one that was asked for, and neighbours are
// alike.
TEST(MixtureField, CoverIsTheFractionOfTheGround) {
  scene::Scene scene = two_species();
  for (const double cover : {0.2, 0.5, 0.8}) {
    scene.species[1].habitat.cover = cover;
    scene.species[1].habitat.feature_m = 1.0;
    const MixtureField field(scene, plane(0.0));
    EXPECT_NEAR(stands_on(scene, field, 1), cover, 0.03);
    EXPECT_EQ(stands_on(scene, field, 0), 1.0);
    EXPECT_EQ(field.present(), (std::vector<int>{0, 1}));
  }
  scene.species[1].habitat.feature_m = 6.0;
  const MixtureField field(scene, plane(0.0));
  int alike = 0;
  constexpr int places = 1000;
  for (int k = 0; k < places; ++k) {
    const glm::dvec2 at_m(0.06 * k, 0.037 * k);
    alike += field.at(at_m) == field.at(at_m + glm::dvec2(0.3, 0.0));
  }
  EXPECT_GT(alike, 0.93 * places);
}

// On a large terrain patches lie in groups: many here, few a hundred metres on. All over it they
// stand on as much of the ground as was asked for. Without groups squares of 60 m would differ by
// two hundredths.
TEST(MixtureField, PatchesOfALargeTerrainLieInGroups) {
  scene::Scene scene = two_species();
  scene.terrain.size_m = 6000.0;
  scene.species[1].habitat.cover = 0.3;
  scene.species[1].habitat.feature_m = 2.0;
  const MixtureField field(scene, Heightfield(61, 6000.0, 0.0F));
  constexpr int squares = 14;
  double sum = 0.0, sum_of_squares = 0.0;
  for (int k = 0; k < squares * squares; ++k) {
    const glm::dvec2 corner_m = 410.0 * glm::dvec2(k % squares, k / squares);
    const double stands = stands_on(scene, field, 1, {corner_m, 60.0});
    sum += stands / (squares * squares);
    sum_of_squares += stands * stands / (squares * squares);
  }
  EXPECT_NEAR(sum, 0.3, 0.04);
  EXPECT_GT(std::sqrt(sum_of_squares - sum * sum), 0.1);
}

// However large the patches are: groups of theirs are never as large as the terrain.
TEST(MixtureField, CoverIsTheFractionOfALargeTerrain) {
  scene::Scene scene = two_species();
  scene.terrain.size_m = 12000.0;
  scene.species[1].habitat.cover = 0.12;
  for (const double feature_m : {3.0, 30.0, 100.0})
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      scene.seed = seed;
      scene.species[1].habitat.feature_m = feature_m;
      const MixtureField field(scene, Heightfield(61, 12000.0, 0.0F));
      EXPECT_NEAR(stands_on(scene, field, 1, {.size_m = 12000.0}), 0.12, 0.03) << feature_m;
    }
}

TEST(MixtureField, KeepsToSlopesAndHeights) {
  scene::Scene scene = two_species();
  scene.species[1].habitat.gentlest_deg = 25.0;
  EXPECT_EQ(stands_on(scene, MixtureField(scene, plane(std::tan(0.26))), 1), 0.0);  // 15 degrees
  EXPECT_EQ(stands_on(scene, MixtureField(scene, plane(std::tan(0.61))), 1), 1.0);  // 35 degrees
  scene.species[1].habitat.gentlest_deg = 0.0;
  scene.species[1].habitat.lowest_m = 2.0;
  scene.species[1].habitat.highest_m = 4.0;
  scene.species[1].habitat.feature_m = 0.2;
  const MixtureField band(scene, plane(0.1));  // 0 to 6 m
  EXPECT_EQ(stands_on(scene, band, 1, {{0.0, 0.0}, 18.0}), 0.0);
  EXPECT_EQ(stands_on(scene, band, 1, {{0.0, 22.0}, 16.0}), 1.0);
  EXPECT_EQ(stands_on(scene, band, 1, {{0.0, 42.0}, 18.0}), 0.0);
}

// A border of wetness: as much of the terrain as the key says, hollows alone, softly.
TEST(MixtureField, RushesStandInTheHollows) {
  Heightfield terrain(121, 60.0);
  for (int j = 0; j < 121; ++j)
    for (int i = 0; i < 121; ++i)
      terrain.at(i, j) = static_cast<float>(-std::cos(2.0 * std::numbers::pi * i / 30.0));
  scene::Scene scene = two_species();
  scene.species[1].habitat.driest = 0.7;
  scene.species[1].habitat.feature_m = 0.5;
  const MixtureField field(scene, terrain);
  EXPECT_NEAR(stands_on(scene, field, 1), 0.3, 0.03);
  EXPECT_EQ(stands_on(scene, field, 1, {{29.0, 10.0}, 2.0}), 1.0);  // about a trough
  EXPECT_EQ(stands_on(scene, field, 1, {{36.0, 10.0}, 3.0}), 0.0);  // about a crest
  scene.species[0].habitat.wettest = 0.7;
  const MixtureField both(scene, terrain);
  EXPECT_EQ(stands_on(scene, both, 0, {{29.0, 10.0}, 2.0}), 0.0);
  EXPECT_EQ(stands_on(scene, both, 0, {{36.0, 10.0}, 3.0}), 1.0);
  EXPECT_EQ(both.present(), (std::vector<int>{0, 1, 2}));
}

// White in the north-east quarter, grey in the south-west one: there it stands on half of the
// ground.
TEST(MixtureField, AMaskDecides) {
  const test::TemporaryFolder folder("habitat");
  Image mask(4, 4, 1);
  for (const int x : {2, 3})
    for (const int y : {0, 1}) *mask.pixel(x, y) = 1.0F;
  for (const int x : {0, 1})
    for (const int y : {2, 3}) *mask.pixel(x, y) = 0.5F;
  write_image(folder.path() / "mask.exr", mask, PixelFormat::half);
  scene::Scene scene = two_species();
  scene.species[1].habitat.mask = (folder.path() / "mask.exr").string();
  scene.species[1].habitat.feature_m = 0.6;
  const MixtureField field(scene, plane(0.1));
  EXPECT_EQ(stands_on(scene, field, 1, {{40.0, 40.0}, 18.0}), 1.0);
  EXPECT_EQ(stands_on(scene, field, 1, {{2.0, 40.0}, 18.0}), 0.0);
  EXPECT_EQ(stands_on(scene, field, 1, {{40.0, 2.0}, 18.0}), 0.0);
  EXPECT_NEAR(stands_on(scene, field, 1, {{2.0, 2.0}, 18.0}), 0.5, 0.05);
}

TEST(MixtureField, SomethingStandsWhereNothingIsLikely) {
  scene::Scene scene = two_species();
  for (scene::Species& species : scene.species) species.habitat.cover = 0.3;
  const MixtureField field(scene, plane(0.0));
  EXPECT_EQ(field.present(), (std::vector<int>{0, 1, 2}));
  const double first = stands_on(scene, field, 0), second = stands_on(scene, field, 1);
  EXPECT_GT(first + second, 1.0);
  EXPECT_NEAR(first, second, 0.1);
}

/// How often what grows changes on the way across the square in steps of `step_m`, on many ways.
int changes(const MixtureField& field, double step_m) {
  int count = 0;
  for (int way = 0; way < 100; ++way)
    for (double x = step_m; x < 60.0; x += step_m)
      count += field.at({x, 0.6 * way}) != field.at({x - step_m, 0.6 * way});
  return count;
}

// Smooth borders of large patches looked like camouflage: the finer one looks, the more there is of
// a ragged one.
TEST(MixtureField, PatchesHaveRaggedBorders) {
  scene::Scene scene = two_species();
  scene.species[1].habitat.cover = 0.45;
  scene.species[1].habitat.feature_m = 30.0;
  const MixtureField field(scene, plane(0.0));
  EXPECT_GT(changes(field, 0.6), 2 * changes(field, 6.0));
}

TEST(MixtureField, PatchesOfTwoSpeciesAreNotTheSame) {
  scene::Scene scene = two_species();
  scene.species.resize(3);
  for (const std::size_t k : {1U, 2U}) {
    scene.species[k].habitat.cover = 0.5;
    scene.species[k].habitat.feature_m = 1.0;
  }
  const MixtureField field(scene, plane(0.0));
  std::map<int, int> found;
  for (int k = 0; k < 10000; ++k) ++found[field.at({0.6 * (k % 100), 0.6 * (k / 100)})];
  for (int mixture = 0; mixture < 4; ++mixture) EXPECT_NEAR(found[mixture], 2500, 400) << mixture;
}

// Bare where no species has its habitat, half bare where the only one has half; and as before where
// one grows everywhere.
TEST(MixtureField, GroundWithoutAHabitatIsBare) {
  scene::Scene scene = two_species();
  for (scene::Species& species : scene.species) species.habitat.highest_m = 3.0;
  scene.species[1].habitat.cover = 0.2;
  const FactorMap growth = growth_map(scene, plane(0.1));
  EXPECT_EQ(growth.sample(30.0, 5.0), 1.0F);
  EXPECT_EQ(growth.sample(30.0, 55.0), 0.0F);
  scene.species[0].habitat = {};
  EXPECT_EQ(growth_map(scene, plane(0.1)).sample(30.0, 55.0), 1.0F);
  scene.species.resize(1);
  scene.species[0].habitat.cover = 0.4;
  const FactorMap thin = growth_map(scene, plane(0.1));
  double sum = 0.0;
  for (const float value : thin.values()) sum += double{value};
  EXPECT_NEAR(sum / static_cast<double>(thin.values().size()), 0.4, 0.03);
}

}  // namespace
}  // namespace wold::place
