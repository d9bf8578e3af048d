#include "grass/ageing/withering_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grass/ageing/model_table.h"
#include "support/places.h"

namespace wold::grass {
namespace {

/// The leaf of prospect_vectors.toml and of the published colours.
scene::Scene published_leaf() {
  scene::Scene scene;
  scene.ageing.chlorophyll_ug_cm2 = 45.0;
  scene.ageing.carotenoid_ug_cm2 = 5.0;
  scene.ageing.brown_pigment = 0.25;
  return scene;
}

/// The same for "straw": it has 1 ug/cm2 of carotenoids, and keeps 0.3 of the leaf's.
scene::Scene leaf_of_published_straw() {
  scene::Scene scene = published_leaf();
  scene.ageing.carotenoid_ug_cm2 = 1.0 / 0.3;
  return scene;
}

std::size_t index_of(const WitheringCurves& curves, double wanted_nm) {
  const auto& nm = curves.wavelength_nm;
  return static_cast<std::size_t>(std::find(nm.begin(), nm.end(), wanted_nm) - nm.begin());
}

TEST(WitheringCurves, StatesAreAHundredthApart) {
  const WitheringCurves curves = withering_curves(scene::Scene{});
  ASSERT_EQ(curves.states.size(), 101u);
  for (std::size_t i = 0; i <= 100; ++i)
    EXPECT_DOUBLE_EQ(curves.states[i].weathering, static_cast<double>(i) / 100.0);
}

// Water over 240 % of dry mass. NWCG PMS 437 after Rothermel 1983: the green pales from 100 %,
// leaves yellow and cure from 80 to 50 %, are cured below 30 %; dead grass keeps 4 % and more (Ziel
// et al. 2018).
TEST(WitheringCurves, WaterAndChlorophyllPassTheStagesOfCuring) {
  for (const WitheredState& state : withering_curves(scene::Scene{}).states) {
    const double moisture = 240.0 * state.water;
    EXPECT_GE(moisture, 4.0);
    if (moisture > 200.0) {
      EXPECT_GT(state.chlorophyll, 0.9);
    }
    if (moisture < 80.0) {
      EXPECT_LT(state.chlorophyll, 0.4);
    }
    if (moisture < 30.0) {
      EXPECT_LT(state.chlorophyll, 0.05);
    }
  }
  const WitheringCurves curves = withering_curves(scene::Scene{});
  EXPECT_LT(240.0 * curves.states[100].water, 30.0);
  EXPECT_NEAR(curves.states[50].chlorophyll, 0.5, 1e-5);  // half-way of a leaf's logistic fall
}

TEST(WitheringCurves, CarotenoidsOutlastChlorophyllAndInThePaperStay) {
  for (const WitheredState& state : withering_curves(scene::Scene{}).states)
    EXPECT_GE(state.carotenoid, state.chlorophyll);
  scene::Scene paper;
  paper.ageing.colour = scene::ColourModel::paper;
  for (const WitheredState& state : withering_curves(paper).states)
    EXPECT_EQ(state.carotenoid, 1.0);
}

TEST(WitheringCurves, TheScenesOwnCurveIsAmongTheShippedOrTheUsers) {
  scene::Scene scene;
  scene.ageing.water = {"cold", {}};
  scene.ageing.chlorophyll.points = {{0.0, 1.0}, {0.5, 0.9}, {1.0, 0.25}};
  const WitheringCurves curves = withering_curves(scene);
  for (const ShippedCurve& curve : curves.water) {
    EXPECT_EQ(curve.is_scenes_own, curve.name == "cold");
    ASSERT_EQ(curve.values.size(), curves.states.size());
    for (std::size_t i = 0; i < curve.values.size() && curve.is_scenes_own; ++i)
      EXPECT_EQ(curve.values[i], curves.states[i].water);
  }
  for (const ShippedCurve& curve : curves.chlorophyll) EXPECT_FALSE(curve.is_scenes_own);
  EXPECT_DOUBLE_EQ(curves.states[50].chlorophyll, 0.9);
  EXPECT_DOUBLE_EQ(curves.states[100].chlorophyll, 0.25);
}

// Paper 1, section 3.1: veins lose less, shrinkage slows down and comes to rest.
TEST(WitheringCurves, StrainsRiseAndLevelOff) {
  for (const char* name : {"standard", "ample", "cold"}) {
    scene::Scene scene;
    scene.ageing.water.name = name;
    const auto states = withering_curves(scene).states;
    double steepest = 0.0;
    for (std::size_t i = 1; i < states.size(); ++i) {
      const TissueState& tissue = states[i].tissue;
      const double gained = tissue.strain_mesophyll - states[i - 1].tissue.strain_mesophyll;
      EXPECT_GT(gained, 0.0) << name << " " << i;
      EXPECT_GT(tissue.strain_mesophyll, tissue.strain_vein);
      EXPECT_NEAR(tissue.strain_mesophyll / tissue.strain_vein, 0.6 / 0.15, 1e-9);
      steepest = std::max(steepest, gained);
    }
    const double last = states[100].tissue.strain_mesophyll - states[99].tissue.strain_mesophyll;
    EXPECT_LT(last, 0.25 * steepest) << name;
    // k ln(1 + b x) / b with x the water lost.
    const double lost = 1.0 - states[100].water;
    EXPECT_NEAR(states[100].tissue.strain_vein, 0.15 * std::log(1.0 + 2.0 * lost) / 2.0, 1e-12);
  }
}

/// The polar angle that a blade's tip reaches: theta = lean + c sqrt(r) (paper 1, section 3.1),
/// with the arc length ds = sqrt(1 + c^2 r / 4) dr summed up to the blade's length.
double summed_tip_angle_deg(double lean_deg, double droop, double length_m) {
  constexpr double step_m = 1e-6;
  double radius_m = 0.0;
  for (double arc_m = 0.0; arc_m < length_m; radius_m += step_m)
    arc_m += step_m * std::sqrt(1.0 + 0.25 * droop * droop * (radius_m + 0.5 * step_m));
  return lean_deg + droop * std::sqrt(radius_m) * 180.0 / std::numbers::pi;
}

TEST(WitheringCurves, TheTipSinksFromTheFreshBladesAngleToTheGround) {
  scene::Scene scene;
  const auto states = withering_curves(scene).states;
  EXPECT_NEAR(states[0].tip_angle_deg, summed_tip_angle_deg(14.0, 1.0, 0.32), 1e-2);
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_GE(states[i].tip_angle_deg, i == 0 ? 14.0 : states[i - 1].tip_angle_deg);
    EXPECT_LE(states[i].tip_angle_deg, 90.0);
  }
  scene.ageing.droop = 6.0;
  EXPECT_FLOAT_EQ(withering_curves(scene).states[100].tip_angle_deg, 90.0F);
  scene.grass.bend = scene.ageing.droop = 0.0;
  for (const WitheredState& state : withering_curves(scene).states)
    EXPECT_NEAR(state.tip_angle_deg, 14.0, 1e-4);
}

TEST(WitheringCurves, SpectraAreThoseOfAnIndependentProspect) {
  const ModelTable vectors(wold::test::tests_folder() / "grass/prospect_vectors.toml");
  const std::vector<double>& wavelength_nm = vectors.column("wavelength_nm");
  const std::vector<double>& reflectance = vectors.column("reflectance");
  const WitheringCurves curves = withering_curves(published_leaf());
  const WitheringCurves withered = withering_curves(leaf_of_published_straw());
  constexpr std::size_t green = 1;
  constexpr std::size_t straw = 5;
  for (std::size_t i = 0; i < wavelength_nm.size(); ++i) {
    const std::size_t at = index_of(curves, wavelength_nm[i]);
    ASSERT_LT(at, curves.wavelength_nm.size()) << wavelength_nm[i];
    EXPECT_NEAR(curves.states[0].reflectance[at], reflectance[green * wavelength_nm.size() + i],
                1e-4);
    EXPECT_NEAR(withered.states[100].reflectance[at], reflectance[straw * wavelength_nm.size() + i],
                1e-3);
  }
}

// A green leaf's marks: the green peak near 550 nm, chlorophyll's red minimum near 680 nm, and the
// red edge, whose steepest places were measured between 685 and 740 nm (Gitelson, Merzlyak and
// Lichtenthaler 1996, Journal of Plant Physiology 148:501). Few carotenoids move the peak towards
// the blue, so the leaf has those of a sun leaf: a fifth of the chlorophyll (Lichtenthaler and
// Babani 2022, Photosynthetica 60:3).
TEST(WitheringCurves, FreshLeavesHaveAGreenPeakAndARedEdge) {
  scene::Scene sun_leaf;
  sun_leaf.ageing.chlorophyll_ug_cm2 = 40.0;
  sun_leaf.ageing.carotenoid_ug_cm2 = 8.0;
  const WitheringCurves curves = withering_curves(sun_leaf);
  const std::vector<double>& fresh = curves.states[0].reflectance;
  const auto begin = [&](double nm) {
    return fresh.begin() + static_cast<std::ptrdiff_t>(index_of(curves, nm));
  };
  const auto nm_at = [&](auto place) {
    return curves.wavelength_nm[static_cast<std::size_t>(place - fresh.begin())];
  };
  EXPECT_NEAR(nm_at(std::max_element(begin(450.0), begin(650.0))), 550.0, 10.0);
  EXPECT_NEAR(nm_at(std::min_element(begin(600.0), begin(750.0))), 680.0, 10.0);
  double edge_nm = 0.0;
  double steepest = 0.0;
  for (auto place = begin(660.0); place != begin(760.0); ++place)
    if (place[1] - place[0] > steepest) {
      steepest = place[1] - place[0];
      edge_nm = nm_at(place) + 2.5;
    }
  EXPECT_GT(edge_nm, 685.0);
  EXPECT_LT(edge_nm, 740.0);
}

TEST(WitheringCurves, ReflectancesAreShares) {
  for (const auto colour : {scene::ColourModel::prospect, scene::ColourModel::paper}) {
    scene::Scene scene;
    scene.ageing.colour = colour;
    for (const WitheredState& state : withering_curves(scene).states)
      for (const double value : state.reflectance) {
        EXPECT_GE(value, 0.0);
        EXPECT_LE(value, 1.0);
      }
  }
}

void expect_8_bit(const glm::dvec3& srgb, const glm::dvec3& want) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(255.0 * srgb[i], want[i], 1.0) << "channel " << i;
}

TEST(WitheringCurves, ColoursAreThoseOfGreenLeafAndStraw) {
  expect_8_bit(withering_curves(published_leaf()).states[0].srgb, {62.0, 102.0, 51.0});
  expect_8_bit(withering_curves(leaf_of_published_straw()).states[100].srgb, {182.0, 165.0, 129.0});
}

}  // namespace
}  // namespace wold::grass
