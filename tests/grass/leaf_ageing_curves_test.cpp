#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/error.h"
#include "grass/ageing/ageing_curves.h"
#include "grass/mechanics/dynamics.h"
#include "scene/registry.h"

namespace wold::grass {
namespace {

TEST(AgeingCurves, FallFromFreshToDead) {
  for (const char* name : {"standard", "ample", "cold"}) {
    const Curve water = load_curve(CurveKind::water, {name, {}});
    EXPECT_EQ(water(0.0), 1.0);
    EXPECT_GE(water(1.0), 0.04 / 2.4);  // 4 to 29 % of dry mass: Ziel et al. 2018
    EXPECT_LE(water(1.0), 0.29 / 2.4);
    for (int i = 0; i < 1000; ++i) EXPECT_GT(water(i / 1000.0), water((i + 1) / 1000.0)) << name;
  }
}

TEST(AgeingCurves, ChlorophyllIsTheRescaledLogistic) {
  struct Model {
    const char* name;
    double half, steepness;
  };
  for (const Model& model :
       {Model{"standard", 0.50, 29.0}, Model{"drought", 0.35, 29.0}, Model{"cold", 0.60, 36.0}}) {
    const auto logistic = [&](double x) {
      return 1.0 / (1.0 + std::exp(model.steepness * (x - model.half)));
    };
    const double scale = logistic(0.0) - logistic(1.0);
    const Curve curve = load_curve(CurveKind::chlorophyll, {model.name, {}});
    for (int i = 0; i <= 1000; ++i) {
      const double x = i / 1000.0;
      EXPECT_NEAR(curve(x), (logistic(x) - logistic(1.0)) / scale, 3e-3) << model.name << " " << x;
      if (i > 0) {
        EXPECT_LT(curve(x), curve((i - 1) / 1000.0)) << model.name << " " << x;
      }
    }
    EXPECT_NEAR(curve(model.half) * scale + logistic(1.0), 0.5, 3e-3);
  }
}

// Real leaves stay green, then yellow within about a week (Mattila et al. 2018), in a season of two
// to three months; the meadow's mean falls slowly, because every blade has its own onset:
// science's logistic 1 / (1 + exp(10 (wd - 0.45))). Litter of the year before is left out, and the
// leaves of a fresh meadow are 0.14 old in the mean.
TEST(AgeingCurves, LeavesYellowFastAndTheMeadowSlowly) {
  const Curve leaf = load_curve(CurveKind::chlorophyll, {"standard", {}});
  const auto degree_of = [&](double content) {
    int i = 0;
    while (leaf(i / 1000.0) > content) ++i;
    return i / 1000.0;
  };
  EXPECT_LT(degree_of(0.1) - degree_of(0.9), 0.2);
  scene::Scene scene;
  scene.ageing.fresh_spread = 0.14;
  for (int step = 0; step <= 20; ++step) {
    const double weathering = step / 20.0;
    double sum = 0.0;
    int blades = 0;
    for (const Blade& blade : scatter_blades(
             scene.grass, scene.ageing, {scene.grass.patch_m, scene.grass.blades, scene.seed, 0})) {
      if (blade.head_start >= 0.8F) continue;
      ++blades;
      for (const double along : {0.1, 0.3, 0.5, 0.7, 0.9})
        sum += leaf(AgeingModel::local_age(AgeingModel::blade_age(blade, weathering), along)) / 5.0;
    }
    EXPECT_NEAR(sum / blades, 1.0 / (1.0 + std::exp(10.0 * (weathering - 0.45))), 0.1)
        << weathering;
  }
}

TEST(AgeingCurves, ScenariosDifferAsTheirNamesSay) {
  const auto half = [](CurveKind kind, const char* name) {
    return load_curve(kind, {name, {}})(0.5);
  };
  EXPECT_GT(half(CurveKind::water, "ample"), half(CurveKind::water, "standard"));
  EXPECT_LT(half(CurveKind::chlorophyll, "drought"), half(CurveKind::chlorophyll, "standard"));
  EXPECT_GT(half(CurveKind::chlorophyll, "cold"), half(CurveKind::chlorophyll, "standard"));
}

TEST(AgeingCurves, RatesNeverGrowYoungerAndDifferAsTheirNamesSay) {
  std::map<std::string, Curve> rates;
  for (const std::string& name : scene::find_key("grass.mingle")->words) {
    const Curve& rate = rates.emplace(name, load_curve(CurveKind::rate, {name, {}})).first->second;
    EXPECT_EQ(rate(0.0), 0.0) << name;
    EXPECT_LE(rate(1.0), 1.0) << name;
    for (int i = 0; i < 1000; ++i)
      EXPECT_LE(rate(i / 1000.0), rate((i + 1) / 1000.0) + 1e-12) << name;
  }
  for (const double wd : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    EXPECT_EQ(rates.at("steady")(wd), wd);
    EXPECT_GT(rates.at("early")(wd), wd);
    EXPECT_LT(rates.at("late")(wd), wd);
    EXPECT_LT(rates.at("slow")(wd), wd);
    EXPECT_LT(rates.at("evergreen")(wd), rates.at("slow")(wd));
  }
  EXPECT_LT(rates.at("slow")(1.0), 1.0);
  EXPECT_GT(rates.at("sudden")(0.6) - rates.at("sudden")(0.4), 0.8);
}

TEST(AgeingCurves, TheUsersPointsWinOverTheName) {
  const std::vector<glm::dvec2> points = {{0.0, 1.0}, {0.25, 0.8}, {0.3, 0.1}, {1.0, 0.0}};
  const Curve curve = load_curve(CurveKind::water, {"standard", points});
  for (const glm::dvec2& point : points) EXPECT_EQ(curve(point.x), point.y);
}

TEST(AgeingCurves, AnUnknownNameIsAnsweredWithThoseThereAre) {
  try {
    load_curve(CurveKind::water, {"soggy", {}});
    FAIL() << "an unknown curve was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "no water curve is called \"soggy\"; there are ample, cold, standard");
  }
}

}  // namespace
}  // namespace wold::grass
