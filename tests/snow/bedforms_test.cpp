#include "snow/bedforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::snow {
namespace {

constexpr double day_s = 86400.0;

Weather steady(double temperature_c, double wind_m_s, double precipitation_mm_h = 0.0) {
  scene::Scene scene;
  scene.weather.temperature_c = temperature_c;
  scene.weather.precipitation_mm_h = precipitation_mm_h;
  scene.wind.speed_m_s = wind_m_s;
  scene.wind.heading_deg = 130.0;
  return {scene, nullptr};
}

// Kochanski 2020: snow is only flat in winds below 6.4 m/s.
TEST(ShapedByWind, IsSnowInStrongWindAlone) {
  EXPECT_EQ(shaped_by_wind(steady(-5.0, 6.0, 0.01), day_s, 0.0, /*lain=*/false), 0.0);
  EXPECT_GT(shaped_by_wind(steady(-5.0, 12.0, 0.01), day_s, 0.0, /*lain=*/false), 0.95);
  EXPECT_LT(shaped_by_wind(steady(-5.0, 12.0, 0.01), day_s / 24.0, 0.0, /*lain=*/false), 0.5);
}

TEST(ShapedByWind, LastsUntilItIsBuriedOrThaws) {
  EXPECT_EQ(shaped_by_wind(steady(-5.0, 2.0), 30.0 * day_s, 0.0, /*lain=*/true), 1.0);
  EXPECT_LT(shaped_by_wind(steady(-5.0, 2.0, 1.5), day_s, 0.0, /*lain=*/true), 0.1);
  EXPECT_LT(shaped_by_wind(steady(4.0, 2.0), 3.0 * day_s, 0.0, /*lain=*/true), 0.1);
  EXPECT_EQ(shaped_by_wind(steady(4.0, 2.0), 3.0 * day_s, 2000.0, /*lain=*/true), 1.0);
  EXPECT_LT(shaped_by_wind(steady(5.0, 14.0), 3.0 * day_s, 0.0, /*lain=*/true), 0.1);
}

// Nor is ground that no snow has fallen on.
TEST(ShapedByWind, IsNoBareGround) {
  const test::TemporaryFolder folder("bare_ground");
  scene::Scene scene;
  scene.weather.table = (folder.path() / "table.csv").string();
  write_file(scene.weather.table,
             "hours,temperature_c,wind_speed_m_s,precipitation_mm_h\n0,-5,14,0\n20,-5,14,0\n"
             "21,-5,1,0\n22,-5,1,0.4\n30,-5,1,0.4\n");
  EXPECT_LT(shaped_by_wind(Weather(scene, nullptr), 30.0 * 3600.0, 0.0, /*lain=*/false), 0.01);
}

// Else it would begin anew with each frame.
TEST(ShapedByWind, DoesNotDependOnWhatIsAskedBefore) {
  const Weather weather = steady(-5.0, 9.0, 0.01);
  const double once = shaped_by_wind(weather, 5.0 * 3600.0, 0.0, /*lain=*/false);
  EXPECT_GT(once, shaped_by_wind(weather, 4.5 * 3600.0, 0.0, /*lain=*/false));
  EXPECT_LT(once, shaped_by_wind(weather, 5.5 * 3600.0, 0.0, /*lain=*/false));
}

TEST(ShapedByWind, GoesWhereTheWindBlewBeforeTheFilm) {
  EXPECT_EQ(shaping_heading_deg(steady(-5.0, 2.0)), 130.0);
  const test::TemporaryFolder folder("bedforms");
  scene::Scene scene;
  scene.weather.table = (folder.path() / "table.csv").string();
  write_file(scene.weather.table,
             "hours,wind_speed_m_s,wind_heading_deg\n0,10,40\n9,10,40\n10,10,200\n");
  scene.weather.earlier_h = 8.0;
  EXPECT_NEAR(shaping_heading_deg(Weather(scene, nullptr)), 40.0, 1e-6);
}

/// Of ascents on a square of 60 m, along a wind to the north-east and across it.
struct Moments {
  glm::dvec2 mean{0.0}, mean2{0.0};
  double mean3_along = 0.0;
};

Moments moments(double step_m) {
  constexpr int places = 300;
  const Bedforms forms(45.0, 3);
  Moments of;
  for (int k = 0; k < places * places; ++k) {
    const glm::dvec2 up = forms.ascent(0.2 * glm::dvec2(k % places, k / places), step_m);
    const glm::dvec2 ascent = glm::dvec2(up.x + up.y, up.x - up.y) / std::sqrt(2.0);
    of.mean += ascent / (1.0 * places * places);
    of.mean2 += ascent * ascent / (1.0 * places * places);
    of.mean3_along += ascent.x * ascent.x * ascent.x / (1.0 * places * places);
  }
  return of;
}

// What is carved is no slope, and a walker's boot does not fall down it.
TEST(Bedforms, AreLowAndLevelOnTheMean) {
  const Moments fine = moments(0.01);
  EXPECT_LT(glm::length(fine.mean), 0.01);
  const double steepness = std::sqrt(fine.mean2.x + fine.mean2.y);
  EXPECT_GT(steepness, 0.08);
  EXPECT_LT(steepness, 0.35);
}

TEST(Bedforms, AreRidgesAlongTheWindSteepAgainstIt) {
  const Moments of_sastrugi = moments(0.3);
  EXPECT_GT(of_sastrugi.mean2.y, 2.0 * of_sastrugi.mean2.x);
  EXPECT_GT(of_sastrugi.mean3_along, 0.2 * std::pow(of_sastrugi.mean2.x, 1.5));
}

TEST(Bedforms, AreSeenAsFarAsTheStepShowsThem) {
  const double fine = moments(0.01).mean2.x, coarser = moments(1.0).mean2.x;
  EXPECT_GT(fine, 2.0 * coarser);
  EXPECT_GT(coarser, 0.0);
  EXPECT_EQ(moments(25.0).mean2, glm::dvec2(0.0));
}

}  // namespace
}  // namespace wold::snow
