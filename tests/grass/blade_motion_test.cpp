#include "grass/mechanics/blade_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grass/geometry/axis.h"
#include "grass/mechanics/dynamics.h"
#include "grass/mechanics/elastica.h"
#include "grass/mechanics/mechanics.h"
#include "grass/texel/texel_file.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

const Curve drying({{0.0, 1.0}, {1.0, 0.05}});
/// Dries to a fifth, then drinks until nothing is lacking.
const Curve wetted_again({{0.0, 1.0}, {0.5, 0.2}, {0.75, 0.8}, {1.0, 1.0}});

scene::Ageing ageing_by(DroopRule rule) {
  scene::Ageing ageing;
  ageing.droop_rule = rule;
  ageing.motion = scene::AgeingMotion::points;
  return ageing;
}

Blade drooping_blade() {
  Blade blade = test::straight_blade();
  blade.fresh_droop = 0.8F;
  blade.droop_rate = 2.0F;
  blade.keel_depth_m = 0.0006F;
  return blade;
}

double length_m(const Blade& blade, const scene::Ageing& ageing, double lost) {
  return double{blade.length_m} * double{blade_pose(blade, ageing, lost, 1.0).length_scale};
}

/// Where its points are at an age.
VeinPlaces places(BladeMotion& motion, const Blade& blade, const scene::Ageing& ageing,
                  const Curve& water, double age) {
  const double lost = 1.0 - water(age);
  return vein_places(blade, ageing, motion.at(age), lost, length_m(blade, ageing, lost), 0.0);
}

VeinPlaces places(const Blade& blade, const scene::Ageing& ageing, const Curve& water, double age,
                  int steps = BladeMotion::usual_steps) {
  BladeMotion motion(blade, ageing, water, steps);
  return places(motion, blade, ageing, water, age);
}

double farthest_m(const VeinPlaces& a, const VeinPlaces& b) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    farthest = std::max(farthest, double{glm::distance(a[i], b[i])});
  return farthest;
}

double tip_m(const VeinPlaces& places) { return double{places.back().y}; }

/// The closed form at the same places.
VeinPlaces closed_form(const Blade& blade, const scene::Ageing& ageing, const Curve& water,
                       double age) {
  const BladePose pose = blade_pose(blade, ageing, 1.0 - water(age), 1.0);
  const BladeAxis axis(blade, pose);
  VeinPlaces places;
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = axis.at(blade.length_m * pose.length_scale * static_cast<float>(i) / vein_segments)
                    .position_m;
  return places;
}

class EveryLaw : public testing::TestWithParam<DroopRule> {};
INSTANTIATE_TEST_SUITE_P(BladeMotion, EveryLaw,
                         testing::Values(DroopRule::paper, DroopRule::elastica));

// The paper's law by steps is its closed form, in the limit of small steps.
TEST(BladeMotion, FollowsTheClosedFormOfThePapersLaw) {
  const Blade blade = drooping_blade();
  const scene::Ageing ageing = ageing_by(DroopRule::paper);
  for (double age : {0.0, 0.3, 0.7, 1.0})
    EXPECT_LT(
        farthest_m(places(blade, ageing, drying, age), closed_form(blade, ageing, drying, age)),
        0.01 * double{blade.length_m})
        << age;
}

TEST_P(EveryLaw, HalvingTheStepHalvesTheError) {
  const Blade blade = drooping_blade();
  const scene::Ageing ageing = ageing_by(GetParam());
  VeinPlaces coarse = places(blade, ageing, drying, 1.0, 16);
  double last = 0.0;
  for (int steps = 32; steps <= 256; steps *= 2) {
    const VeinPlaces fine = places(blade, ageing, drying, 1.0, steps);
    const double change = farthest_m(fine, coarse) / double{blade.length_m};
    RecordProperty("change at " + std::to_string(steps), std::to_string(change));
    if (last > 0.0) {
      EXPECT_NEAR(last / change, 2.0, 0.5) << steps;
    }
    last = change;
    coarse = fine;
  }
  EXPECT_LT(last, 0.01);
}

TEST_P(EveryLaw, KeepsItsLength) {
  const Blade blade = drooping_blade();
  const scene::Ageing ageing = ageing_by(GetParam());
  for (double age = 0.0; age <= 1.0; age += 0.125) {
    const VeinPlaces at = places(blade, ageing, drying, age);
    double sum = 0.0;
    for (std::size_t i = 1; i < at.size(); ++i) sum += double{glm::distance(at[i], at[i - 1])};
    EXPECT_NEAR(sum / length_m(blade, ageing, 1.0 - drying(age)), 1.0, 1e-4);
  }
}

TEST_P(EveryLaw, AStateDependsOnTheAgeAlone) {
  const Blade blade = drooping_blade();
  const scene::Ageing ageing = ageing_by(GetParam());
  BladeMotion often(blade, ageing, drying);
  for (double age = 0.0; age < 0.7; age += 0.013) often.at(age);
  const BladeHistory history(blade, ageing, drying);
  BladeMotion once(blade, ageing, drying);
  const auto angle = once.at(0.703).angle;
  EXPECT_EQ(often.at(0.703).angle, angle);
  EXPECT_EQ(history.at(0.703).angle, angle);
}

TEST_P(EveryLaw, SinksAsItDriesAndStaysDown) {
  for (double lean_deg : {5.0, 14.0, 40.0})
    for (double water_left : {0.05, 0.3}) {
      Blade blade = drooping_blade();
      blade.lean = static_cast<float>(lean_deg * test::degree);
      const scene::Ageing ageing = ageing_by(GetParam());
      const Curve water({{0.0, 1.0}, {1.0, water_left}});
      BladeMotion motion(blade, ageing, water);
      const double fresh = tip_m(places(motion, blade, ageing, water, 0.0));
      double lowest = fresh;
      for (double age = 0.0; age <= 1.0; age += 1.0 / 32.0) {
        const double tip = tip_m(places(motion, blade, ageing, water, age));
        EXPECT_LE(tip, lowest + 0.015 * double{blade.length_m}) << lean_deg << " deg, age " << age;
        lowest = std::min(tip, lowest);
      }
      EXPECT_LT(lowest, fresh - 0.1 * double{blade.length_m});
    }
}

// What turgor gives: a wetted blade rises, but not to where it stood; without turgor it stays down.
TEST_P(EveryLaw, AWettedBladeRisesByItsTurgorAlone) {
  const Blade blade = drooping_blade();
  scene::Ageing ageing = ageing_by(GetParam());
  const double fresh = tip_m(places(blade, ageing, wetted_again, 0.0));
  const double dry = tip_m(places(blade, ageing, wetted_again, 0.5));
  const double limp = tip_m(places(blade, ageing, wetted_again, 0.7));
  const double wet = tip_m(places(blade, ageing, wetted_again, 1.0));
  const double length = double{blade.length_m};
  EXPECT_LT(dry, fresh - 0.1 * length);
  EXPECT_GT(wet, dry + 0.01 * length);
  EXPECT_LT(wet, fresh - 0.05 * length);
  // Below the turgor loss point water gives nothing back but length: tissues swell.
  EXPECT_LT(limp, dry + 0.01 * length);
  ageing.turgor_support = 0.0;
  EXPECT_LT(tip_m(places(blade, ageing, wetted_again, 1.0)),
            tip_m(places(blade, ageing, wetted_again, 0.5)) + 0.02 * length);
}

// A fresh blade bears its own weight: the heavy elastica of its load.
TEST(BladeMotion, FreshBladesAreElasticae) {
  const scene::Ageing ageing = ageing_by(DroopRule::elastica);
  for (float keel_m : {0.0004F, 0.0006F, 0.001F}) {
    Blade blade = drooping_blade();
    blade.keel_depth_m = keel_m;
    const Elastica known = heavy_elastica(double{blade.lean}, fresh_load(blade));
    const glm::dvec2 tip(places(blade, ageing, drying, 0.0).back());
    EXPECT_LT(glm::distance(tip / double{blade.length_m}, known.back().place), 0.01)
        << fresh_load(blade);
  }
}

TEST(BladeMotion, MassFallsAsWaterLeaves) {
  const Blade blade = drooping_blade();
  const scene::Ageing ageing = ageing_by(DroopRule::elastica);
  BladeMotion motion(blade, ageing, drying);
  const auto mass_kg = [&] {
    double sum = 0.0;
    for (double mass : motion.points().mass_kg) sum += mass;
    return sum;
  };
  const double fresh_kg = mass_kg();
  // 800 kg/m3 x 0.2 mm x 6 mm x 0.18 m
  EXPECT_NEAR(fresh_kg, 800.0 * 0.2e-3 * 6e-3 * 0.18, 1e-9);
  motion.at(1.0);
  EXPECT_NEAR(mass_kg() / fresh_kg, 1.0 - 0.95 * 240.0 / 340.0, 1e-6);
}

TEST_P(EveryLaw, SnowBendsAndLeavesNoTrace) {
  const Blade blade = drooping_blade();
  const AgeingModel model(ageing_by(GetParam()), 0.1);
  double last = 1.0;
  for (double snow : {0.0, 0.3, 1.0}) {
    const BladePose pose = model.pose(blade, 0.1, snow);
    ASSERT_TRUE(pose.vein);
    EXPECT_LT(tip_m(*pose.vein), last);
    last = tip_m(*pose.vein);
  }
  EXPECT_EQ(*model.pose(blade, 0.1, 0.0).vein, *model.pose(blade, 0.1).vein);
}

}  // namespace
}  // namespace wold::grass
