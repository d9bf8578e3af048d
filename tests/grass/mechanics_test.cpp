#include "grass/mechanics/mechanics.h"

#include <gtest/gtest.h>

#include "small_meadow.h"

namespace wold::grass {
namespace {

TEST(Mechanics, ShrinkageFollowsItsClosedFormAndSlowsDown) {
  EXPECT_NEAR(relieved_loss(1.0, 2.0), 0.5493061443, 1e-9);  // ln 3 / 2
  EXPECT_NEAR(relieved_loss(0.5, 1.0), 0.4054651081, 1e-9);  // ln 1.5
  EXPECT_DOUBLE_EQ(relieved_loss(0.7, 0.0), 0.7);
  EXPECT_NEAR(relieved_loss(0.7, 1e-9), 0.7, 1e-8);
  double step = 1.0;
  for (int i = 1; i <= 10; ++i) {
    const double gained = relieved_loss(i / 10.0, 2.0) - relieved_loss((i - 1) / 10.0, 2.0);
    EXPECT_GT(gained, 0.0);
    EXPECT_LT(gained, step);
    step = gained;
  }
}

// Paper 1, section 3.1: kv < km, sigma = E eps, veins resist more, E grows.
TEST(Mechanics, VeinsAreStifferAndShrinkLess) {
  const scene::Ageing ageing;
  double modulus = 0.0;
  for (double lost : {0.1, 0.4, 0.7, 1.0}) {
    const TissueState tissue = tissue_state(ageing, lost);
    EXPECT_LT(tissue.strain_vein, tissue.strain_mesophyll);
    EXPECT_LT(tissue.strain_mesophyll, 1.0);
    EXPECT_GT(tissue.modulus_vein_pa, tissue.modulus_mesophyll_pa);
    EXPECT_GT(tissue.modulus_vein_pa, modulus);
    EXPECT_DOUBLE_EQ(tissue.stress_vein_pa, tissue.modulus_vein_pa * tissue.strain_vein);
    EXPECT_DOUBLE_EQ(tissue.stress_mesophyll_pa,
                     tissue.modulus_mesophyll_pa * tissue.strain_mesophyll);
    modulus = tissue.modulus_vein_pa;
  }
  EXPECT_NEAR(tissue_state(ageing, 1.0).modulus_vein_pa, 1.5e9, 1.0);  // E0 (1 + b), b = 2
}

TEST(Mechanics, DryBladesAreShorterThinnerAndHang) {
  const scene::Ageing ageing;
  Blade blade = test::straight_blade();
  blade.fresh_droop = 1.0F;
  blade.droop_rate = 2.0F;
  const BladePose fresh = blade_pose(blade, ageing, 0.0, 1.0);
  EXPECT_FLOAT_EQ(fresh.droop, 1.0F);
  EXPECT_FLOAT_EQ(fresh.length_scale, 1.0F);
  EXPECT_FLOAT_EQ(fresh.mesophyll_width, 1.0F);
  const BladePose dry = blade_pose(blade, ageing, 1.0, 1.0);
  EXPECT_NEAR(dry.droop, 1.0 + 2.0 * 0.5493061443, 1e-6);
  EXPECT_LT(dry.mesophyll_width, dry.vein_width);
  // Lengths follow the veins, which carry 90 to 95 % of the stiffness or more (Vincent 1982).
  EXPECT_LT(dry.vein_width - dry.length_scale, 0.1F * (dry.vein_width - dry.mesophyll_width));
  EXPECT_GE(dry.vein_width, dry.length_scale);
  // Isotropic loss of volume: (1 - kv S)^(1/3).
  EXPECT_NEAR(std::pow(double{dry.vein_width}, 3.0), 1.0 - 0.15 * 0.5493061443, 1e-6);
}

// B = q L^3 / (E I) of a flat blade of 3 mm x 0.2 mm, 800 kg/m3 and 0.5 GPa, from its parts:
// q = 4.71e-3 N/m, E I = 1.0e-6 N m2.
TEST(Mechanics, FreshLoadIsThatOfAThinBlade) {
  Blade blade = test::straight_blade();
  blade.keel_depth_m = 0.2e-3F;
  const double weight = 800.0 * 9.81 * 3e-3 * 0.2e-3;
  const double stiffness = 0.5e9 * 3e-3 * std::pow(0.2e-3, 3.0) / 12.0;
  for (double length_m : {0.05, 0.1, 0.2}) {
    blade.length_m = static_cast<float>(length_m);
    EXPECT_NEAR(fresh_load(blade) / (weight * std::pow(length_m, 3.0) / stiffness), 1.0, 1e-5);
  }
  const double flat = fresh_load(blade);
  EXPECT_NEAR(flat, 37.7, 0.1);
  blade.keel_depth_m = 0.6e-3F;
  EXPECT_NEAR(fresh_load(blade) / flat, 1.0 / 9.0, 1e-5);
}

// It wilts: E I at 60 % of the water is below the fresh one while most of the weight is left. Then
// weight goes and walls stiffen (Balsamo et al. 2006, Annals of Botany 97:985).
TEST(Mechanics, BladesLoseTheirStiffnessThenTheirWeight) {
  const scene::Ageing ageing;
  EXPECT_DOUBLE_EQ(relative_load(ageing, 0.0), 1.0);
  for (double lost = 0.0; lost < 0.195; lost += 0.01)
    EXPECT_LT(relative_load(ageing, lost), relative_load(ageing, lost + 0.01));
  EXPECT_GT(relative_load(ageing, 0.4), 1.5);
  EXPECT_LT(relative_load(ageing, 1.0), relative_load(ageing, 0.2));
  // Walls alone: the fraction of turgor sets how far a blade wilts.
  scene::Ageing woody;
  woody.turgor_support = 0.0;
  EXPECT_NEAR(relative_load(ageing, 0.5) / relative_load(woody, 0.5),
              1.0 / (1.0 - ageing.turgor_support), 1e-9);
  // No support, no thickness, no stiffening: still a number.
  scene::Ageing limp;
  limp.turgor_support = 0.99;
  limp.mesophyll_shrinkage = 1.0;
  limp.stiffening = 0.0;
  EXPECT_TRUE(std::isfinite(relative_load(limp, 1.0)));
}

// Of walls alone, which do not stiffen: a blade of three quarters of its thickness has 27/64 of its
// stiffness, and bears what is left of 240 parts of water and 100 of dry mass.
TEST(Mechanics, StiffnessGoesWithTheCubeOfTheThickness) {
  scene::Ageing walls;
  walls.turgor_support = 0.0;
  walls.stiffening = 0.0;
  walls.mesophyll_shrinkage = 0.5;
  EXPECT_NEAR(relative_load(walls, 0.5), (220.0 / 340.0) / (27.0 / 64.0), 1e-9);
}

TEST(Mechanics, FallenBladesStayDown) {
  const scene::Ageing ageing;
  const Curve drying({{0.0, 1.0}, {1.0, 0.05}});
  const Curve rained_on({{0.0, 1.0}, {0.4, 0.7}, {0.6, 1.0}, {1.0, 0.6}});
  for (const Curve& water : {drying, rained_on}) {
    const Curve heaviest = heaviest_load(ageing, water);
    double last = 1.0;
    for (double age = 0.0; age <= 1.0; age += 0.01) {
      EXPECT_GE(heaviest(age), last);
      last = heaviest(age);
    }
    EXPECT_DOUBLE_EQ(heaviest(0.0), 1.0);
    EXPECT_NEAR(last, relative_load(ageing, 0.2), 0.02 * last);
  }
}

// A blade that has wilted and drinks again gets back what turgor held, and no more.
TEST(BladePose, DroopsStillWhenItIsWettedAgain) {
  const scene::Ageing ageing;
  Blade blade = test::straight_blade();
  blade.droop_rate = 2.0F;
  const float fresh = blade_pose(blade, ageing, 0.0, 1.0).droop;
  const float dry = blade_pose(blade, ageing, 0.8, 1.0).droop;
  const float wet = blade_pose(blade, ageing, {0.0, 0.8}, 1.0).droop;
  EXPECT_GT(wet, fresh + 0.05F * (dry - fresh));
  EXPECT_LT(wet, dry);
  scene::Ageing no_turgor = ageing;
  no_turgor.turgor_support = 0.0;
  EXPECT_FLOAT_EQ(blade_pose(blade, no_turgor, {0.0, 0.8}, 1.0).droop, dry);
}

}  // namespace
}  // namespace wold::grass
