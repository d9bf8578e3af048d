#include "scene/species.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/parse.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

const char* const two = R"([[species]]
name = "fescue"
share = 3
height = 0.2
[[species]]
name = "cocksfoot"
width = 0.008
[grass]
height = 0.4
blades = 401
[ageing]
litter = 0.3
)";

std::string problems_of(const std::string& text) {
  try {
    parse_scene(text, "a.toml", {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Species, TakeWhatTheyDoNotSayFromTheTablesWhereverTheseStand) {
  const Scene scene = parse_scene(two, "a.toml", {});
  ASSERT_EQ(scene.species.size(), 2U);
  EXPECT_EQ(scene.species[0].plant.height_m, 0.2);
  EXPECT_EQ(scene.species[1].plant.height_m, 0.4);
  EXPECT_EQ(scene.species[1].plant.width_m, 0.008);
  EXPECT_EQ(scene.species[0].physiology.litter, 0.3);
}

TEST(Species, TakeWhatTheCommandLineSaysForAllOfThem) {
  const std::vector<std::string> overrides = {"species[2].width=0.01", "grass.height=0.5"};
  const Scene scene = parse_scene(two, "a.toml", overrides);
  EXPECT_EQ(scene.species[0].plant.height_m, 0.2);
  EXPECT_EQ(scene.species[1].plant.height_m, 0.5);
  EXPECT_EQ(scene.species[1].plant.width_m, 0.01);
}

TEST(Species, AreWrittenSoThatTheyReadBackTheSame) {
  const Scene scene = parse_scene(two, "a.toml", {});
  EXPECT_EQ(parse_scene(resolved_toml(scene), "b.toml", {}), scene);
}

TEST(Species, ShareTheBladesToTheLastOne) {
  Scene scene = parse_scene(two, "a.toml", {});
  EXPECT_EQ(blades_of(scene), (std::vector<int>{301, 100}));
  scene.species.push_back(scene.species[0]);
  scene.grass.blades = 100;
  EXPECT_EQ(blades_of(scene), (std::vector<int>{43, 14, 43}));
  scene.species[1].share = scene.species[2].share = 0.001;
  EXPECT_EQ(blades_of(scene), (std::vector<int>{98, 1, 1})) << "none is without a blade";
  scene.grass.blades = 2;
  EXPECT_EQ(blades_of(scene), (std::vector<int>{1, 1, 0}));
}

TEST(Species, OfASceneWithoutThemIsThatOfItsTables) {
  Scene scene;
  scene.grass.height_m = 0.1;
  scene.ageing.litter = 0.5;
  const std::vector<Species> species = species_of(scene);
  ASSERT_EQ(species.size(), 1U);
  EXPECT_EQ(species[0].plant, static_cast<const Plant&>(scene.grass));
  EXPECT_EQ(species[0].physiology, static_cast<const Physiology&>(scene.ageing));
  EXPECT_EQ(blades_of(scene), std::vector<int>{400});
}

TEST(Species, MeanBladeIsThatOfAllBlades) {
  const Scene scene = parse_scene(two, "a.toml", {});
  EXPECT_NEAR(mean_grass(scene).height_m, 0.75 * 0.2 + 0.25 * 0.4, 1e-12);
  EXPECT_NEAR(mean_grass(scene).width_m, 0.75 * 0.0056 + 0.25 * 0.008, 1e-12);
  EXPECT_NEAR(blade_area_m2(scene), 0.5 * (301 * 0.2 * 0.0056 + 100 * 0.4 * 0.008), 1e-12);
}

TEST(Species, ThatAreShrubsStandAboveTheGround) {
  Scene scene = parse_scene(two, "a.toml", {});
  EXPECT_EQ(rooted_fraction(scene, {0, 1}), 1.0);
  scene.species[1].plant.crown_m = 0.7;
  EXPECT_NEAR(standing_m(scene.species[1].plant), 0.7 + 0.4, 1e-12);
  EXPECT_NEAR(max_standing_m(scene.species[1].plant), 0.7 + 0.4 * (1.0 + 2.2 * 0.22), 1e-12);
  EXPECT_EQ(rooted_fraction(scene, {1}), 0.0);
  const double grass = 401 * 0.2 * 0.0056, shrub = 401 * 0.4 * 0.008;
  EXPECT_NEAR(rooted_fraction(scene, {0, 1}), grass / (grass + shrub), 1e-12);
}

TEST(Species, ThatAreShrubsHaveOthersAroundThem) {
  Scene scene;
  scene.species.resize(3);
  for (const std::size_t shrub : {0, 2}) scene.species[shrub].plant.crown_m = 0.7;
  EXPECT_EQ(without_shrubs(scene, 0), 0);  // they stand everywhere
  EXPECT_FALSE(has_placed_shrubs(scene, 0));
  for (Species& one : scene.species) one.habitat.cover = 0.5;
  EXPECT_EQ(without_shrubs(scene, 0b000), 0b101);
  EXPECT_EQ(without_shrubs(scene, 0b001), 0b101);
  EXPECT_EQ(without_shrubs(scene, 0b101), 0b101);
  EXPECT_EQ(without_shrubs(scene, 0b010), 0b010);  // nothing else grows there
  EXPECT_TRUE(has_placed_shrubs(scene, 0b010));
  EXPECT_FALSE(has_placed_shrubs(scene, 0b101));
}

TEST(Species, ThatAreShrubsHaveTheirLeavesOverTheGrass) {
  Scene scene = parse_scene(two, "a.toml", {});
  scene.species.push_back(scene.species[1]);
  scene.species[1].plant.crown_m = 0.7;
  scene.species[1].share = 2.5;
  EXPECT_EQ(blades_of(scene), (std::vector<int>{301, 1003, 100}));
  EXPECT_EQ(blades_of(scene, {1, 2}), (std::vector<int>{1003, 401}));
  EXPECT_EQ(blades_of(scene, {1}), std::vector<int>{1003});
  scene.species[1].share = 0.001;
  EXPECT_EQ(blades_of(scene), (std::vector<int>{301, 1, 100}));
}

TEST(Species, ThatAreShrubsAreTheTopOfWhatTheyCover) {
  Scene scene = parse_scene(two, "a.toml", {});
  Species& shrub = scene.species[1];
  shrub.plant.crown_m = 0.7;
  const auto mean_m = [&](double cover) {
    shrub.habitat.cover = cover;
    return mean_grass(scene).height_m;
  };
  EXPECT_NEAR(mean_m(0.1), 0.9 * 0.2 + 0.1 * 1.1, 1e-12);
  EXPECT_NEAR(mean_m(0.0), 0.2, 1e-12);
  EXPECT_NEAR(mean_m(1.0), 1.1, 1e-12);
  scene.species.push_back(shrub);
  scene.species[2].plant.crown_m = 0.3;
  EXPECT_NEAR(mean_grass(scene).height_m, 0.5 * 1.1 + 0.5 * 0.7, 1e-12) << "no more than all of it";
  scene.species.erase(scene.species.begin());
  scene.species[0].habitat.cover = 0.0;
  scene.species[0].share = 3.0;
  EXPECT_NEAR(mean_grass(scene).height_m, 0.75 * 1.1 + 0.25 * 0.7, 1e-12) << "nothing else grows";
}

TEST(Species, ThatAreShrubsHaveNoMoreLeavesThanCanBeLit) {
  EXPECT_THAT(
      problems_of("[grass]\nblades = 4000\n[[species]]\n[[species]]\nshare = 12\n"
                  "width = 0.001\ncrown = 0.5\n"),
      testing::HasSubstr("species[2].share: found 12, with which the shrubs of a patch have "
                         "48000 blades on their twigs (grass.blades times their share), "
                         "expected at most 40000"));
}

TEST(Species, AreBlamedByTheirOwnKeys) {
  EXPECT_THAT(problems_of("[[species]]\n[[species]]\nmesophyll_shrinkage = 0.1\n"),
              testing::HasSubstr("a.toml:3:1: species[2].vein_shrinkage: found 0.15, expected less "
                                 "than 0.1 (species[2].mesophyll_shrinkage)"));
  EXPECT_THAT(problems_of("[[species]]\nheight = 5\n"), testing::HasSubstr("species[1].height"));
  EXPECT_THAT(problems_of("[grass]\nblades = 1\n[[species]]\nshare = 1000\n[[species]]\n"),
              testing::HasSubstr("species[2].share: found 1, which leaves this species none"));
  EXPECT_THAT(problems_of("[[species]]\nheigth = 0.1\n"),
              testing::HasSubstr("did you mean \"species[1].height\""));
}

TEST(Species, ThatFlowerAreGrassWithStiffStalks) {
  EXPECT_THAT(problems_of("[[species]]\n[[species]]\npetals = 5\nclumps = 3\n"),
              testing::HasSubstr("a.toml:3:1: species[2].petals: found 5, expected 0 for fur "
                                 "(species[2].clumps is 3)"));
  EXPECT_THAT(problems_of("[[species]]\npetals = 5\nmotion = 'points'\n"),
              testing::HasSubstr("species[1].motion: found \"points\", expected \"closed_form\" "
                                 "for a species that flowers (species[1].petals is 5)"));
  EXPECT_THAT(problems_of("[[species]]\npetal_colour = 'green'\n"),
              testing::HasSubstr("expected \"white\", \"yellow\", \"pink\""));
  EXPECT_EQ(problems_of("[[species]]\npetals = 0\nmotion = 'points'\n"), "");
  EXPECT_THAT(problems_of("[[species]]\npetals = 3\npetal_length = 0.1\n[grass]\npatch = 0.2\n"),
              testing::HasSubstr("species[1].petals: found petals and a disc of up to 0.1 m"));
  EXPECT_THAT(problems_of("[grass]\nblades = 4000\n[[species]]\n[[species]]\npetals = 20\n"
                          "petal_length = 0.005\npetal_width = 0.001\n"),
              testing::HasSubstr("species[2].petals: found 20, with which a patch has 46000 blades "
                                 "and petals (grass.blades is 4000), expected at most 40000"));
}

const char* const four = R"([[species]]
share = 1
[[species]]
share = 2
driest = 0.8
[[species]]
share = 3
[[species]]
share = 4
cover = 0.5
)";

// By hand: the second and the fourth have a habitat.
TEST(Species, WithAHabitatAreMissingInMixtures) {
  const Scene scene = parse_scene(four, "a.toml", {});
  EXPECT_EQ(mixtures_of(scene), (std::vector<Mixture>{{0, 1, 2, 3}, {0, 2, 3}, {0, 1, 2}, {0, 2}}));
  EXPECT_EQ(patch_count(scene), 16);
  EXPECT_EQ(patch_number(scene, 2, 3), 11);
  EXPECT_EQ(mixture_number(scene, 11), 2);
  EXPECT_EQ(mixture_of(scene, 11), (Mixture{0, 1, 2}));
  EXPECT_EQ(blades_of(scene, {0, 2}), (std::vector<int>{100, 300}));
}

TEST(Species, OfWhichNoneGrowsEverywhereLeaveNoMixtureEmpty) {
  Scene scene;
  scene.species.resize(2);
  for (Species& species : scene.species) species.habitat.cover = 0.5;
  EXPECT_EQ(mixtures_of(scene), (std::vector<Mixture>{{0, 1}, {1}, {0}}));
  scene.species.clear();
  EXPECT_EQ(mixtures_of(scene), (std::vector<Mixture>{{0}}));
  EXPECT_EQ(patch_count(scene), scene.grass.variants);
}

TEST(Species, MixtureOfMostLeafIsTheOneOfTheBroadestAlone) {
  Scene scene = parse_scene(two, "a.toml", {});
  EXPECT_EQ(max_blade_area_m2(scene), blade_area_m2(scene));
  scene.species[0].habitat.cover = 0.5;
  EXPECT_NEAR(max_blade_area_m2(scene), 401 * 0.5 * 0.4 * 0.008, 1e-12);
}

TEST(Species, LimitsOfAHabitatLeaveRoom) {
  EXPECT_THAT(
      problems_of("[[species]]\ndriest = 0.6\nwettest = 0.5\n"),
      testing::HasSubstr("a.toml:3:1: species[1].wettest: found 0.5, expected more than 0.6 "
                         "(species[1].driest)"));
  EXPECT_THAT(problems_of("[[species]]\nlowest = 5\nhighest = 4\n"),
              testing::HasSubstr("species[1].highest"));
  EXPECT_THAT(problems_of("[[species]]\ngentlest = 50\nsteepest = 40\n"),
              testing::HasSubstr("species[1].steepest"));
  EXPECT_THAT(problems_of("[[species]]\nshadiest = 1.5\nsunniest = 1.2\n"),
              testing::HasSubstr("species[1].sunniest"));
  std::string many;
  for (int k = 0; k < max_with_habitat; ++k) many += "[[species]]\ncover = 0.5\n";
  EXPECT_EQ(problems_of(many), "");
  EXPECT_THAT(problems_of(many + "[[species]]\ncover = 0.5\n"),
              testing::HasSubstr("[[species]]: found 5 that do not grow everywhere, expected at "
                                 "most 4"));
}

}  // namespace
}  // namespace wold::scene
