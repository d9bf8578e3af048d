#include "sky/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.h"

namespace wold::sky {
namespace {

TEST(Exposure, IsTheMetersWhileTheSunIsUp) {
  for (const double elevation_deg : {0.0, 3.0, 40.0})
    EXPECT_NEAR(dusk_gain(elevation_deg, elevation_deg), 1.0, 1e-12);
}

// A clear day has 30 lx at -4 degrees and 760 lx at sunset (Seidelmann 1992): a card of a fifth of
// it has 1.9 and 48 cd/m2, keys of 0.22 and 0.49 (Krawczyk, Myszkowski and Seidel 2005).
TEST(Exposure, ShowsDuskDim) {
  EXPECT_NEAR(dusk_gain(-4.0, -4.0), 0.22 / 0.49, 0.01);
  EXPECT_NEAR(dusk_gain(-4.0, 20.0), dusk_gain(-4.0, -4.0) * dusk_gain(0.0, 20.0), 1e-12);
}

TEST(Exposure, DimsEvenlyAsTheSunSets) {
  for (double elevation_deg = -4.0; elevation_deg < 20.0; elevation_deg += 0.1) {
    const double now = dusk_gain(elevation_deg, 20.0), later = dusk_gain(elevation_deg - 0.1, 20.0);
    EXPECT_LT(later, now) << elevation_deg;
    EXPECT_GT(later, 0.8 * now) << elevation_deg;
  }
}

/// Of a camera on level ground that looks so far from the sun's azimuth and so high.
double sunward(double sun_deg, double azimuth_deg, double up_m, double gain, double hill_m = 0.0) {
  const light::Daylight day({sun_deg, 90.0}, {2.5});
  Heightfield ground(33, Square{.size_m = 200.0}, 0.0F);
  for (int y = 0; y < 33; ++y)
    for (int x = 24; x < 33; ++x) ground.at(x, y) = static_cast<float>(hill_m);
  landscape::Camera camera;
  camera.eye_m = {100.0, 100.0, 2.0};
  const double azimuth = (90.0 + azimuth_deg) * radians_per_degree;
  camera.target_m =
      camera.eye_m + glm::dvec3(10.0 * std::sin(azimuth), 10.0 * std::cos(azimuth), up_m);
  camera.field_of_view_deg = 60.0;
  return sunward_gain(day, ground, camera, 0.5, gain);
}

/// As metered_gain() has it.
double metered(double sun_deg) {
  return metered_gain(light::Daylight({sun_deg, 90.0}, {2.5}), Subject::meadow);
}

// Photographs of a sunset are exposed for the sky; those of what it lights are not.
TEST(Exposure, IsLessTowardsALowSun) {
  for (const double sun_deg : {0.0, 2.0, 5.0}) {
    EXPECT_LT(sunward(sun_deg, 0.0, 2.0, metered(sun_deg)), 0.5) << sun_deg;
    EXPECT_EQ(sunward(sun_deg, 180.0, 2.0, metered(sun_deg)), 1.0) << sun_deg;
    EXPECT_GE(sunward(sun_deg, 0.0, 2.0, 100.0), 0.25) << sun_deg;
  }
  for (const double azimuth_deg : {0.0, 90.0, 180.0})
    EXPECT_EQ(sunward(50.0, azimuth_deg, 1.0, metered(50.0)), 1.0) << azimuth_deg;
}

// A twentieth of the picture burns out, neither more nor less: what is exposed so needs no more.
TEST(Exposure, LetsATwentiethBurnOut) {
  const double gain = 0.6 * metered(0.0), less = sunward(0.0, 0.0, 2.0, gain);
  ASSERT_GT(less, 0.25);
  ASSERT_LT(less, 1.0);
  EXPECT_EQ(sunward(0.0, 0.0, 2.0, 0.999 * less * gain), 1.0);
  EXPECT_LT(sunward(0.0, 0.0, 2.0, 1.1 * less * gain), 1.0);
}

TEST(Exposure, IsNotThatOfASkyBehindHills) {
  EXPECT_LT(sunward(3.0, 0.0, 0.0, metered(3.0)), 1.0);
  EXPECT_EQ(sunward(3.0, 0.0, 0.0, metered(3.0), 100.0), 1.0);
}

// A camera that turns towards the sun opens and closes evenly.
TEST(Exposure, ChangesEvenlyAsTheCameraTurns) {
  const double gain = metered(3.0);
  double before = sunward(3.0, -120.0, 2.0, gain);
  for (double azimuth_deg = -118.0; azimuth_deg < 120.0; azimuth_deg += 2.0) {
    const double now = sunward(3.0, azimuth_deg, 2.0, gain);
    EXPECT_NEAR(now / before, 1.0, 0.15) << azimuth_deg;
    before = now;
  }
}

}  // namespace
}  // namespace wold::sky
