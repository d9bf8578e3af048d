#include "grass/geometry/flower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "grass/geometry/axis.h"
#include "grass/geometry/blade_bend.h"
#include "grass/geometry/blade_places.h"
#include "grass/geometry/blade_tubes.h"
#include "grass/geometry/snow_ridge.h"
#include "grass/texel/blade_patch.h"
#include "grass/texel/fibres.h"
#include "grass/texel/samples.h"
#include "grass/texel/time_varying_texel.h"
#include "scene/species.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

constexpr int stalks = 60, petals = 8;

scene::Flower daisy() {
  return {petals, 0.012, 0.004, 70.0, scene::PetalColour::white, 0.008, 0.4};
}

Scattering scattering() { return {0.4, stalks, 7, 1, 2}; }

std::vector<Blade> flowers(const scene::Flower& flower = daisy()) {
  return with_flowers(scatter_blades(scene::Plant(), {}, scattering()), flower, scattering());
}

glm::vec3 direction_of(const Blade& blade) {
  return from_plane(blade, {std::sin(blade.lean), std::cos(blade.lean)});
}

glm::vec3 tip_m(const Blade& blade) { return foot_m(blade) + blade.length_m * direction_of(blade); }

AgeingModel model_of(const scene::Flower& flower) { return {{}, 0.12, flower}; }

/// Of a blade of an organ at its own weathering degree.
glm::vec3 albedo_of(scene::PetalColour colour, Organ organ = Organ::petal, double age = 0.0) {
  scene::Flower flower = daisy();
  flower.colour = colour;
  Blade blade;
  blade.organ = organ;
  return model_of(flower).albedo(blade, age, 0.5);
}

/// A meadow of grass and of a flower, each blade for itself.
scene::Scene flower_meadow() {
  scene::Scene scene = test::small_scene();
  scene.species.resize(2);
  for (scene::Species& species : scene.species) species.plant = scene.grass;
  scene.species[0].share = 9.0;
  scene.species[1].flower = daisy();
  return scene;
}

TEST(Flower, IsPetalsAndADiscOnEachStalk) {
  const std::vector<Blade> blades = flowers();
  ASSERT_EQ(blades.size(), stalks * (1U + petals + 1U));
  for (std::size_t i = 0; i < blades.size(); ++i) {
    const std::size_t of_flower = i % (petals + 2);
    EXPECT_EQ(blades[i].organ, of_flower == 0        ? Organ::stalk
                               : of_flower <= petals ? Organ::petal
                                                     : Organ::disc);
  }
  scene::Flower without_disc = daisy();
  without_disc.disc_m = 0.0;
  EXPECT_EQ(flowers(without_disc).size(), stalks * (1U + petals));
}

// They are widest where they end and meet at the stalk's tip, in the mean as far open as asked for.
TEST(Flower, HasItsPetalsAroundTheTipOfTheStalk) {
  const std::vector<Blade> blades = flowers();
  double length_m = 0.0, opening_deg = 0.0;
  glm::dvec3 aside(0.0);
  for (std::size_t i = 0, stalk = 0; i < blades.size(); ++i) {
    if (blades[i].organ == Organ::stalk) stalk = i;
    if (blades[i].organ == Organ::disc) {
      EXPECT_NEAR(glm::distance(foot_m(blades[i]), tip_m(blades[stalk])), 0.0, 1e-5);
    }
    if (blades[i].organ != Organ::petal) continue;
    EXPECT_NEAR(glm::distance(tip_m(blades[i]), tip_m(blades[stalk])), 0.0, 1e-5) << i;
    length_m += double{blades[i].length_m} / (stalks * petals);
    const glm::vec3 outwards = -direction_of(blades[i]);
    const glm::vec3 up = direction_of(blades[stalk]);
    opening_deg += std::acos(double{glm::dot(outwards, up)}) / test::degree / (stalks * petals);
    aside += glm::dvec3(outwards - glm::dot(outwards, up) * up) / double{stalks * petals};
  }
  EXPECT_NEAR(length_m, daisy().length_m, 0.05 * daisy().length_m);
  EXPECT_NEAR(opening_deg, daisy().opening_deg, 2.0);
  // They surround it.
  EXPECT_LT(glm::length(aside), 0.05);
}

// A stock has three stalks, each 0.09 m from the next in the mean; those of different stocks are
// 0.15 m apart on a patch of 0.4 m.
TEST(Flower, GrowsBesideOthersOnThePatch) {
  std::vector<glm::vec2> roots_m;
  for (const Blade& blade : flowers()) {
    if (blade.organ != Organ::stalk) continue;
    for (const float at_m : {blade.root_m.x, blade.root_m.y}) {
      EXPECT_GE(at_m, 0.0F);
      EXPECT_LT(at_m, 0.4F);
    }
    EXPECT_EQ(blade.head_start, 0.0F);
    roots_m.push_back(blade.root_m);
  }
  const auto mean_distance_m = [&](std::size_t first) {
    double sum_m = 0.0;
    for (std::size_t i = first; i + 1 < roots_m.size(); i += 3) {
      const glm::vec2 way_m = roots_m[i + 1] - roots_m[i];
      sum_m += double{glm::length(way_m - 0.4F * glm::round(way_m / 0.4F))};
    }
    return sum_m / (stalks / 3);
  };
  EXPECT_NEAR(mean_distance_m(0), 0.09, 0.03);
  EXPECT_GT(mean_distance_m(2), 0.13);
}

TEST(Flower, IsTheSameAgainAndAnotherOneElsewhere) {
  const auto root_of_second = [](Scattering of) {
    const auto blades = with_flowers(scatter_blades(scene::Plant(), {}, scattering()), daisy(), of);
    return blades[2].root_m;
  };
  EXPECT_EQ(root_of_second(scattering()), root_of_second(scattering()));
  Scattering other = scattering();
  other.variant = 0;
  EXPECT_NE(root_of_second(scattering()), root_of_second(other));
  other = scattering();
  other.sample = 0;
  EXPECT_NE(root_of_second(scattering()), root_of_second(other));
}

// On twigs of a shrub, blades end anywhere: there the flowers are.
TEST(Flower, StandsWhereTheTwigEnds) {
  scene::Plant shrub;
  shrub.crown_m = 0.5;
  shrub.height_m = 0.05;
  const std::vector<Blade> twigs = scatter_blades(shrub, {}, scattering());
  const std::vector<Blade> blades = with_flowers(twigs, daisy(), scattering());
  for (std::size_t i = 0; i < twigs.size(); ++i)
    EXPECT_EQ(foot_m(blades[i * (petals + 2)]), foot_m(twigs[i]));
}

TEST(FlowerColour, IsThatOfItsPigments) {
  using Colour = scene::PetalColour;
  const glm::vec3 white = albedo_of(Colour::white), yellow = albedo_of(Colour::yellow),
                  pink = albedo_of(Colour::pink), violet = albedo_of(Colour::violet),
                  blue = albedo_of(Colour::blue), red = albedo_of(Colour::red);
  EXPECT_GT(std::min({white.r, white.g, white.b}), 0.8F);
  EXPECT_GT(yellow.r, yellow.g);
  EXPECT_GT(yellow.g, 4.0F * yellow.b);
  for (const glm::vec3& purple : {pink, violet}) {
    EXPECT_GT(purple.r, 1.3F * purple.g);
    EXPECT_GT(purple.b, 1.3F * purple.g);
  }
  EXPECT_GT(pink.g, 2.0F * violet.g);
  EXPECT_GT(blue.b, 2.0F * std::max(blue.r, blue.g));
  EXPECT_GT(red.r, 5.0F * std::max(red.g, red.b));
  EXPECT_EQ(albedo_of(Colour::blue, Organ::disc), yellow);
  EXPECT_NE(albedo_of(Colour::blue, Organ::stalk), blue);
}

// van der Kooi et al. 2016: 30 to 60 % come back and 20 to 50 % pass where no pigment absorbs.
TEST(FlowerColour, OfWhitePetalsIsWithinWhatIsMeasured) {
  Blade petal;
  petal.organ = Organ::petal;
  const LeafShade white = model_of(daisy()).shade(petal, 0.0, 0.5);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_GT(white.reflectance[channel], 0.3F);
    EXPECT_LT(white.reflectance[channel], 0.6F);
    EXPECT_GT(white.transmittance[channel], 0.2F);
    EXPECT_LT(white.transmittance[channel], 0.5F);
  }
}

TEST(FlowerModel, IsFreshUntilItFadesAndBrownThen) {
  const double fades = daisy().fades;
  const glm::vec3 fresh = albedo_of(scene::PetalColour::blue);
  EXPECT_EQ(albedo_of(scene::PetalColour::blue, Organ::petal, fades), fresh);
  const glm::vec3 brown = albedo_of(scene::PetalColour::blue, Organ::petal, 1.0);
  EXPECT_GT(brown.r, brown.g);
  EXPECT_GT(brown.g, brown.b);
  EXPECT_LT(brown.b, 0.5F * fresh.b);
}

TEST(FlowerModel, LetsPetalsShrivelAndStalksStand) {
  const AgeingModel model = model_of(daisy());
  const auto pose = [&](Organ organ, double age) {
    Blade blade = test::straight_blade();
    blade.organ = organ;
    blade.fresh_droop = blade.droop_rate = 0.0F;
    return model.pose(blade, age, /*snow=*/0.5);
  };
  for (const Organ organ : {Organ::stalk, Organ::petal, Organ::disc})
    for (const double age : {0.0, 0.5, 1.0}) {
      EXPECT_EQ(pose(organ, age).length_scale, 1.0F);
      EXPECT_EQ(pose(organ, age).droop, 0.0F);
      EXPECT_EQ(pose(organ, age).snow, 0.5F);
    }
  const float young = pose(Organ::petal, 0.4).mesophyll_width;
  EXPECT_EQ(young, pose(Organ::stalk, 0.4).mesophyll_width);
  EXPECT_LT(pose(Organ::petal, 0.6).mesophyll_width, 0.25F * young);
  EXPECT_LT(pose(Organ::petal, 0.6).vein_width, 0.25F);
  EXPECT_EQ(pose(Organ::disc, 0.6).mesophyll_width, pose(Organ::stalk, 0.6).mesophyll_width);
}

TEST(FlowerModel, DiscsAreSolid) {
  Blade disc;
  disc.organ = Organ::disc;
  const LeafShade shade = model_of(daisy()).shade(disc, 0.0, 0.5);
  EXPECT_EQ(shade.transmittance, glm::vec3(0.0F));
  EXPECT_EQ(shade.reflectance, shade.albedo);
}

// On a disc that faces the sky snow lies as on level leaves, though its axis is upright.
TEST(FlowerModel, DiscsHoldSnow) {
  Blade disc = test::straight_blade();
  disc.organ = Organ::disc;
  disc.lean = 0.0F;
  BladePose pose;
  pose.snow = 1.0F;
  EXPECT_GT(snow_ridge(disc, pose, 0.5F, BladeAxis(disc, pose).at(0.09F)).half_height_m, 0.0F);
  disc.organ = Organ::stalk;
  EXPECT_EQ(snow_ridge(disc, pose, 0.5F, BladeAxis(disc, pose).at(0.09F)).half_height_m, 0.0F);
}

TEST(FlowerModel, PetalsAreDull) {
  const AgeingModel model = model_of(daisy());
  Blade blade;
  EXPECT_GT(model.specular(blade, 0.0), 0.1F);
  blade.organ = Organ::petal;
  EXPECT_EQ(model.specular(blade, 0.0), 0.0F);
}

// Wind bends the stalk: the middle of the lowest ring of a petal is as far from its tip as before.
TEST(Flower, GoesWithTheTipOfABentStalk) {
  const scene::Scene scene = flower_meadow();
  const MeadowModel model(scene);
  const BladePatch patch = WitheringPatch(scene, model, 0).at(0.0);
  const BladePlaces places = blade_places(patch, model);
  const Tubes straight = blade_tubes(patch, model, test::slanting_light(), {24.0F, 0.005});
  const Tubes bent_over = bent(straight, places, {6, 2});
  const auto ring_middle = [&](const Tubes& tubes, std::size_t blade, std::size_t ring) {
    const auto corners = static_cast<std::size_t>(tubes.corners);
    glm::vec3 sum_m(0.0F);
    for (std::size_t corner = 0; corner < corners; ++corner)
      sum_m += tubes.vertices_m[(blade * BladePlaces::per_blade + ring) * corners + corner];
    return sum_m / static_cast<float>(corners);
  };
  constexpr std::size_t tip = BladePlaces::per_blade - 1;
  int seen = 0;
  for (std::size_t i = 0, stalk = 0; i < patch.blades.size(); ++i) {
    if (!sits_on_stalk(patch.blades[i])) stalk = i;
    if (patch.blades[i].organ != Organ::petal) continue;
    ++seen;
    EXPECT_NEAR(glm::distance(ring_middle(bent_over, i, 0), ring_middle(bent_over, stalk, tip)),
                glm::distance(ring_middle(straight, i, 0), ring_middle(straight, stalk, tip)),
                1e-5);
    EXPECT_GT(glm::distance(ring_middle(bent_over, i, 0), ring_middle(straight, i, 0)), 0.02F);
  }
  EXPECT_EQ(seen, 10 * petals);
}

// Of fibres as many are of flowers, by area, as of the patch, whatever the step between them; they
// are on top.
TEST(Flower, StandsForAPatchByItsArea) {
  scene::Scene scene = flower_meadow();
  scene.species[1].flower.length_m = 0.03;
  scene.species[1].flower.width_m = 0.012;
  const MeadowModel model(scene);
  const BladePatch patch = WitheringPatch(scene, model, 0).at(0.0);
  double flowers_m2 = 0.0, all_m2 = 0.0;
  for (const Blade& blade : patch.blades) {
    const double area_m2 = double{blade.length_m * blade.radius_m};
    all_m2 += area_m2;
    if (sits_on_stalk(blade)) flowers_m2 += area_m2;
  }
  for (const int step : {1, 4, 5}) {
    const std::vector<Fibre> fibres = representative_fibres(patch, model, 300 / step);
    const auto high =
        std::ranges::count_if(fibres, [](const Fibre& fibre) { return fibre.along == 1.0F; });
    EXPECT_NEAR(static_cast<double>(high) / static_cast<double>(fibres.size()), flowers_m2 / all_m2,
                step == 1 ? 0.02 : 0.04)
        << step;
  }
}

/// What is white in a fresh meadow, as an area, square metres.
double white_m2(const scene::Scene& scene) {
  const MeadowModel model(scene);
  Samples samples(scene, test::small_shape(), 0, model);
  samples.advance_to(0.0);
  const Texel texel = samples.texel();
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < texel.size(); ++i)
    sum_m2 += double{texel.density[i]} * texel.shape.voxel_volume_m3() * double{texel.albedo[i].b};
  return sum_m2;
}

TEST(Flower, IsInTheTexelWithItsArea) {
  scene::Scene scene = flower_meadow();
  double petals_m2 = 0.0;
  for (const Blade& blade : sample_blades(scene, 0, 1))
    if (blade.organ == Organ::petal)
      petals_m2 += test::pi / 4.0 * double{blade.length_m} * double{blade.radius_m};
  scene.species[1].flower.disc_m = 0.0;
  const double with_flowers = white_m2(scene);
  scene.species[1].flower.length_m = scene.species[1].flower.width_m = 1e-5;
  const double added_m2 =
      (with_flowers - white_m2(scene)) / double{albedo_of(scene::PetalColour::white).b};
  EXPECT_NEAR(added_m2, petals_m2, 0.1 * petals_m2);
}

// Petals stand on edge above the turf: broad ones are higher than their axes.
TEST(Flower, IsWithinTheTexel) {
  scene::Scene scene = flower_meadow();
  scene.species[0].plant.height_m = 0.03;
  scene.species[1].plant.height_m = 0.05;
  scene.species[1].flower.length_m = 0.02;
  scene.species[1].flower.width_m = 0.05;
  const TimeVaryingTexel texel(scene, {test::slanting_light()}, {}, {});
  double highest_m = 0.0;
  for (int variant = 0; variant < scene.grass.variants; ++variant)
    for (const Blade& blade : sample_blades(scene, variant, 1))
      if (blade.organ == Organ::petal)
        highest_m = std::max(highest_m, double{blade.root_height_m} +
                                            double{blade.radius_m} * std::sin(double{blade.lean}));
  const TexelShape shape = texel.lod_shape(0);
  EXPECT_LE(highest_m, shape.height * shape.voxel_m);
}

TEST(Flower, IsCountedWhereBladesAre) {
  const scene::Scene scene = flower_meadow();
  EXPECT_EQ(scene::max_drawn(scene), 90 + 10 * (1 + petals + 1));
  scene::Scene bare = scene;
  bare.species[1].flower.petals = 0;
  EXPECT_EQ(scene::max_drawn(bare), 100);
  EXPECT_NEAR(scene::blade_area_m2(scene) - scene::blade_area_m2(bare),
              10 * petals * 0.5 * daisy().length_m * daisy().width_m, 1e-9);
}

}  // namespace
}  // namespace wold::grass
