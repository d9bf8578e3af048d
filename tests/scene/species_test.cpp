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

TEST(Species, AreBlamedByTheirOwnKeys) {
  EXPECT_THAT(problems_of("[[species]]\n[[species]]\nmesophyll_shrinkage = 0.1\n"),
              testing::HasSubstr("a.toml:3:1: species[2].vein_shrinkage: found 0.15, expected less "
                                 "than 0.1 (species[2].mesophyll_shrinkage)"));
  EXPECT_THAT(problems_of("[[species]]\nheight = 5\n"), testing::HasSubstr("species[1].height"));
  EXPECT_THAT(problems_of("[grass]\nblades = 3\n[[species]]\nshare = 1000\n[[species]]\n"),
              testing::HasSubstr("species[2].share: found 1, which leaves this species none"));
  EXPECT_THAT(problems_of("[[species]]\nheigth = 0.1\n"),
              testing::HasSubstr("did you mean \"species[1].height\""));
}

}  // namespace
}  // namespace wold::scene
