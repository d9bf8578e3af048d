#include "grass/mechanics.h"

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
  const BladePose fresh = blade_pose(blade, ageing, 0.0);
  EXPECT_FLOAT_EQ(fresh.droop, 1.0F);
  EXPECT_FLOAT_EQ(fresh.length_scale, 1.0F);
  EXPECT_FLOAT_EQ(fresh.mesophyll_width, 1.0F);
  const BladePose dry = blade_pose(blade, ageing, 1.0);
  EXPECT_NEAR(dry.droop, 1.0 + 2.0 * 0.5493061443, 1e-6);
  EXPECT_LT(dry.mesophyll_width, dry.vein_width);
  // Lengths follow the veins, which carry 90 to 95 % of the stiffness or more (Vincent 1982).
  EXPECT_LT(dry.vein_width - dry.length_scale, 0.1F * (dry.vein_width - dry.mesophyll_width));
  EXPECT_GE(dry.vein_width, dry.length_scale);
  // Isotropic loss of volume: (1 - kv S)^(1/3).
  EXPECT_NEAR(std::pow(double{dry.vein_width}, 3.0), 1.0 - 0.15 * 0.5493061443, 1e-6);
}

}  // namespace
}  // namespace wold::grass
