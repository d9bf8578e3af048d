#include "grass/optics/leaf_colour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/colour.h"

namespace wold::grass {
namespace {

void expect_near(const glm::vec3& got, const glm::dvec3& want, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], tolerance) << "channel " << i;
}

double red_over_green(const glm::vec3& rgb) { return rgb.r / rgb.g; }

scene::Ageing with(scene::ColourModel colour) {
  scene::Ageing ageing;
  ageing.colour = colour;
  ageing.chlorophyll_ug_cm2 = 45.0;  // the leaf of the published colours
  ageing.carotenoid_ug_cm2 = 5.0;
  ageing.brown_pigment = 0.25;
  return ageing;
}

TEST(LeafColour, GoesFromFreshGrassToStraw) {
  // The leaves "green" and "straw" of prospect_vectors.toml.
  scene::Ageing ageing = with(scene::ColourModel::prospect);
  const LeafShade green = LeafColour(ageing)(0.0);
  expect_near(green.reflectance, {0.04842, 0.13279, 0.03348}, 2e-3);
  expect_near(green.albedo, {0.08425, 0.26170, 0.02524}, 2e-3);
  ageing.carotenoid_ug_cm2 = 1.0 / 0.3;  // straw keeps 0.3 of them, that straw has 1
  const LeafShade straw = LeafColour(ageing)(1.0);
  expect_near(straw.reflectance, {0.46889, 0.37751, 0.22080}, 2e-3);
  expect_near(straw.albedo, {0.82115, 0.63368, 0.34133}, 2e-3);
}

TEST(LeafColour, TurnsFromGreenToGoldBeforeStraw) {
  const LeafColour colour(with(scene::ColourModel::prospect));
  double reflectance = 0.0;
  double albedo = 0.0;
  for (int i = 0; i <= 570; ++i) {  // then red leaves the gamut
    const LeafShade shade = colour(i / 1000.0);
    EXPECT_GT(red_over_green(shade.reflectance), reflectance) << i;
    EXPECT_GT(red_over_green(shade.albedo), albedo) << i;
    reflectance = red_over_green(shade.reflectance);
    albedo = red_over_green(shade.albedo);
  }
  // Gold: red leads, blue is still missing; straw is paler.
  const glm::vec3 gold = colour(0.70).reflectance;
  const glm::vec3 straw = colour(1.0).reflectance;
  EXPECT_GT(red_over_green(gold), 1.1);
  EXPECT_LT(gold.b / gold.r, 0.5F * straw.b / straw.r);
}

TEST(LeafColour, StaysInGamutAndHasNoJumps) {
  for (const char* name : {"standard", "ample", "cold"}) {
    scene::Ageing ageing;
    ageing.water.name = name;
    ageing.chlorophyll_ug_cm2 = 10.0;
    ageing.carotenoid_ug_cm2 = 5.0;
    ageing.brown_pigment = 0.6;
    const LeafColour colour(ageing);
    LeafShade before = colour(0.0);
    for (int i = 0; i <= 1000; ++i) {
      const LeafShade shade = colour(i / 1000.0);
      for (const glm::vec3& rgb : {shade.reflectance, shade.transmittance, shade.albedo})
        for (int k = 0; k < 3; ++k) {
          EXPECT_GE(rgb[k], 0.0F);
          EXPECT_LE(rgb[k], 0.99F + 1e-6F);
        }
      EXPECT_LT(glm::distance(shade.albedo, before.albedo), 0.02F);
      before = shade;
    }
  }
}

TEST(LeafColour, PaperTurnsFromGreenToPaleYellow) {
  const LeafColour colour(with(scene::ColourModel::paper));
  double before = 0.0;
  for (int i = 0; i <= 55; ++i) {  // until red is clamped
    const LeafShade shade = colour(i / 100.0);
    EXPECT_GT(red_over_green(shade.albedo), before);
    EXPECT_EQ(shade.albedo, shade.reflectance);
    EXPECT_EQ(shade.transmittance, glm::vec3(0.0F));
    before = red_over_green(shade.albedo);
  }
  // Without chlorophyll: sRGB (255, 254, 243), which the clamp at 0.99 leaves a tint of yellow.
  const glm::vec3 end = colour(1.0).albedo;
  EXPECT_NEAR(end.g, srgb_decoded(254.0 / 255.0), 0.01);
  EXPECT_NEAR(end.b, srgb_decoded(243.0 / 255.0), 0.01);
}

TEST(WitheredLeaf, KeepsCarotenoidsLongerThanChlorophyll) {
  // Lichtenthaler and Babani 2022, Photosynthetica 60:3: chlorophyll over carotenoids falls
  // below 1.
  scene::Ageing ageing;
  ageing.carotenoid_ug_cm2 = 5.0;
  EXPECT_EQ(withered_leaf(ageing, 0.1, 0.3).carotenoid_ug_cm2, 5.0);
  const LeafContent late = withered_leaf(ageing, 0.05, 0.2);
  EXPECT_LT(late.chlorophyll_ug_cm2, late.carotenoid_ug_cm2);
}

}  // namespace
}  // namespace wold::grass
