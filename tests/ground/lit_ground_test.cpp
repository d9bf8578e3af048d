#include "ground/lit_ground.h"

#include <gtest/gtest.h>

#include "film/assemble.h"
#include "film/exporters.h"
#include "grass/optics/light_under_grass.h"
#include "grass/texel/coverage.h"
#include "meadow/film_lights.h"
#include "support/film_parts.h"
#include "support/no_grass.h"

namespace wold::ground {
namespace {

/// A level meadow, seen from 5.2 m above its southern edge; the sun stands 60 degrees high, so that
/// one in the south casts the camera's shadow 3 m before it.
scene::Scene meadow_from_above(double sun_azimuth_deg) {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 161;
  scene.terrain.hill_height_m = 0.0;
  scene.terrain.relief_m = 0.0;
  scene.terrain.streams = 0.0;
  scene.sun.elevation_deg = 60.0;
  scene.sun.azimuth_deg = sun_azimuth_deg;
  scene.camera.eye_m = {4.0, 1.0};
  scene.camera.eye_height_m = 5.2;
  scene.camera.target_m = {4.0, 4.0};
  scene.camera.target_height_m = 0.0;
  scene.ageing.frames = {0.3};
  return scene;
}

/// What the ground's radiance is of its reflectance, which the sun gives each clod of its own.
class LightOnGround {
 public:
  explicit LightOnGround(const scene::Scene& scene)
      : site_(test::site_of(scene)),
        radiance_(film::assemble(scene, site_, test::grass_of(scene, 1), {}, test::no_grass(),
                                 film::needs_of({}))
                      .ground) {}

  glm::vec3 at(double east_m, double north_m) const {
    return radiance_.sample(east_m, north_m) / site_.ground_reflectance.sample(east_m, north_m);
  }

 private:
  place::Site site_;
  ColourMap radiance_;
};

// Where one looks down the sun's rays all of the ground between blades is sunlit, elsewhere about
// as much as of all ground.
TEST(LitGround, HasAHotSpotWhereTheSunIsBehindTheEye) {
  const scene::Scene scene = meadow_from_above(180.0);
  const place::Site site = test::site_of(scene);
  const grass::MeadowModel model(scene);
  const grass::BladePatch patch = grass::WitheringPatch(scene, model, 0).at(0.3);
  const grass::Lighting lighting = meadow::frame_lighting(scene, site, 1);
  const double passing = grass::blade_transmittance(patch.blades, patch.poses, patch.patch_m,
                                                    {lighting.sun_direction});
  const glm::vec3 mean = grass::light_under_grass(patch, model, lighting);
  const glm::vec3 hidden =
      lighting.sun_irradiance * static_cast<float>(lighting.sun_direction.z * (1.0 - passing));
  const LightOnGround behind(scene), ahead(meadow_from_above(0.0));
  const auto brighter = [&](double north_m) {
    return behind.at(4.0, north_m) / ahead.at(4.0, north_m);
  };
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(brighter(4.0)[c], (1.0F + hidden / mean)[c], 0.1);
    EXPECT_LT(brighter(6.0)[c], 1.2);
    EXPECT_GT(brighter(6.0)[c], 1.0);
  }
}

}  // namespace
}  // namespace wold::ground
