#include "sky/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace wold::sky
