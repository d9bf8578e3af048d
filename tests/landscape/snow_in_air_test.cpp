#include "landscape/snow_in_air.h"

#include <gtest/gtest.h>

#include <cmath>

#include "landscape/view.h"

namespace wold::landscape {
namespace {

// A whirl of many faint flakes, as seen in a picture of few pixels, where POV-Ray would end.
TEST(SnowInAir, HasNoFlakesTooFaintToEndARay) {
  scene::Scene scene;
  scene.terrain.size_m = 30.0;
  scene.terrain.samples = 33;
  scene.snowfall.strength = "blizzard";
  scene.wind.field = "tornado";
  scene.camera.eye_m = {15.0, 1.5};
  scene.camera.target_m = {15.0, 24.0};
  const Site site = make_site(scene);
  Landscape landscape;
  landscape.terrain = site.terrain;
  landscape.camera = resolved_camera(scene.camera, site.terrain, 0.0);
  landscape.width_px = 64;
  landscape.height_px = 36;
  landscape.sky = Image(8, 4, 3);
  const double extinction_per_m = snow_extinction_per_m(scene, site, 1);
  EXPECT_NEAR(extinction_per_m, 2.49e-3 * std::pow(4.0, 1.05), 0.02 * extinction_per_m);
  let_it_snow(scene, site, SnowyAir(site.day, extinction_per_m, 0.2), landscape);
  ASSERT_GT(landscape.flakes.flakes.size(), 1000u);
  for (const Flake& flake : landscape.flakes.flakes) {
    EXPECT_GE(flake.opacity, 0.15F);
    EXPECT_LE(flake.opacity, 1.0F);
    EXPECT_LT(static_cast<std::size_t>(flake.picture), landscape.flakes.pictures.size());
  }
}

}  // namespace
}  // namespace wold::landscape
