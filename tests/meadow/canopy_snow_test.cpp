#include "meadow/canopy_snow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/film_parts.h"

namespace wold::meadow {
namespace {

constexpr double hour_s = 3600.0;

/// The fraction after constant weather.
double fraction_after(double hours, double temperature_c, double snowfall_mm_h,
                      double fraction = 0.0, double leaf_area_index = 2.0) {
  const auto weather = [&](double) { return CanopyWeather{temperature_c, snowfall_mm_h}; };
  return intercepted_fraction(leaf_area_index, fraction, weather, 0.0, hours * hour_s);
}

// 0.16 of 6.0 (0.27 + 46 / 100) per unit of leaf area.
TEST(CanopySnow, CapacityFollowsTheLeafArea) {
  EXPECT_NEAR(canopy_capacity_mm(1.0), 0.7008, 1e-12);
  EXPECT_NEAR(canopy_capacity_mm(3.0), 2.1024, 1e-12);
}

// Snow that falls faster than it comes off: Hedstrom and Pomeroy's 1 - exp(-C P / I_max).
TEST(CanopySnow, CatchesAsHedstromAndPomeroySay) {
  for (const double fallen_mm : {0.1, 0.5, 1.0, 3.0}) {
    const double cover = 1.0 - std::exp(-1.0);
    const double caught = 1.0 - std::exp(-cover * fallen_mm / 1.4016);
    EXPECT_NEAR(fraction_after(0.1, -5.0, 10.0 * fallen_mm), caught, 2e-3);
  }
}

TEST(CanopySnow, ThreeToSixMillimetresLoadAMeadow) {
  EXPECT_GT(fraction_after(1.0, -3.0, 4.0, 0.0, 1.0), 0.85);
  EXPECT_GT(fraction_after(1.0, -3.0, 6.0, 0.0, 3.0), 0.85);
  EXPECT_LT(fraction_after(1.0, -3.0, 0.2, 0.0, 2.0), 0.2);
}

TEST(CanopySnow, ComesOffInDaysInTheColdInHoursInTheWarm) {
  EXPECT_NEAR(fraction_after(60.0, -5.0, 0.0, 0.8), 0.8 / std::exp(1.0), 1e-9);
  EXPECT_NEAR(fraction_after(1.5, 3.0, 0.0, 0.8), 0.8 / std::exp(1.0), 1e-9);
  EXPECT_LT(fraction_after(12.0, 2.0, 0.0, 1.0), 1e-3);
}

// However long the weather lasts, it stays in [0, 1]; an interval in two halves is the same.
TEST(CanopySnow, IsBoundedAndAddsUp) {
  const double half = fraction_after(6.0, -2.0, 0.05);
  EXPECT_NEAR(fraction_after(6.0, -2.0, 0.05, half), fraction_after(12.0, -2.0, 0.05), 1e-12);
  EXPECT_LE(fraction_after(10000.0, -20.0, 50.0), 1.0);
  EXPECT_GE(fraction_after(10000.0, 20.0, 0.0, 1.0), 0.0);
  EXPECT_EQ(fraction_after(0.0, -2.0, 1.0, 0.3), 0.3);
}

// Half a millimetre within half an hour before the film, as much in its first ten minutes.
TEST(CanopySnow, OfASceneFollowsItsWeather) {
  scene::Scene scene;
  scene.weather.temperature_c = -3.0;
  EXPECT_EQ(test::grass_of(scene, 1).snow, 0.0);
  scene.weather.precipitation_mm_h = 1.0;
  scene.weather.earlier_h = 0.5;
  scene.film.frame_seconds = 600.0;
  const double leaf_area = 400 * 0.5 * 0.32 * 0.0056 / (0.6 * 0.6);
  EXPECT_NEAR(test::grass_of(scene, 1).snow, fraction_after(0.5, -3.0, 1.0, 0.0, leaf_area), 1e-9);
  EXPECT_NEAR(test::grass_of(scene, 2).snow,
              fraction_after(0.5 + 1.0 / 6.0, -3.0, 1.0, 0.0, leaf_area), 1e-9);
  scene.weather.temperature_c = 3.0;  // rain
  EXPECT_EQ(test::grass_of(scene, 2).snow, 0.0);
  scene.weather.temperature_c = -3.0;
  scene.snow_cover.cover = scene::CoverModel::none;
  EXPECT_EQ(test::grass_of(scene, 2).snow, 0.0);
}

}  // namespace
}  // namespace wold::meadow
