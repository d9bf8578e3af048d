#include "snow/lake_ice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold::snow {
namespace {

Weather weather_of(double temperature_c, double earlier_h) {
  scene::Scene scene;
  scene.weather.temperature_c = temperature_c;
  scene.weather.earlier_h = earlier_h;
  return {scene, nullptr};
}

// Stefan 1891: the root of 2 k / (L rho) times the frost, with k = 2.22 W/m/K, L = 334 kJ/kg and
// rho = 917 kg/m3: 0.354 m after 100 degrees and days.
TEST(LakeIce, GrowsByStefansLaw) {
  const double k = 2.22, latent = 334e3, density = 917.0, frost_k_s = 10.0 * 10.0 * 86400.0;
  EXPECT_NEAR(lake_ice_m(weather_of(-10.0, 240.0), 0.0, 0.0),
              std::sqrt(2.0 * k / (latent * density) * frost_k_s), 0.005);
}

TEST(LakeIce, GrowsWithTheTimeAndWithTheHeight) {
  const Weather weather = weather_of(-4.0, 100.0);
  EXPECT_GT(lake_ice_m(weather, 5.0 * 86400.0, 0.0), lake_ice_m(weather, 0.0, 0.0));
  EXPECT_NEAR(lake_ice_m(weather, 0.0, 1000.0),
              lake_ice_m(weather, 0.0, 0.0) * std::sqrt(10.5 / 4.0), 1e-6);
}

TEST(LakeIce, IsNoneInSummer) { EXPECT_EQ(lake_ice_m(weather_of(12.0, 500.0), 1e6, 0.0), 0.0); }

}  // namespace
}  // namespace wold::snow
