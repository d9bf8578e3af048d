#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meadow/frame_grass.h"
#include "meadow/lean_light.h"
#include "meadow/mean_beam.h"
#include "support/film_parts.h"

namespace wold::meadow {
namespace {

constexpr double frames_per_s = 24.0;

/// Level ground in a strong wind to the south-east, 24 frames a second.
scene::Scene windy_scene() {
  scene::Scene scene;
  scene.terrain.size_m = 24.0;
  scene.terrain.hill_height_m = 0.0;
  scene.terrain.relief_m = 0.0;
  scene.terrain.samples = 65;
  scene.film.frame_seconds = 1.0 / frames_per_s;
  scene.ageing.frames = {0.1, 0.1, 0.1};  // a stiffer blade would answer in another way
  scene.wind = {.heading_deg = 135.0,
                .lean_deg = 0.0,
                .waves_deg = 0.0,
                .speed_m_s = 8.0,
                .turbulence = 0.5,
                .grass = scene::GrassMotion::waving};
  scene.camera = {.eye_m = {12.0, 11.0},
                  .eye_height_m = 300.0,
                  .target_m = {12.0, 12.0},
                  .field_of_view_deg = 8.0};
  scene.render.size_px = {100, 100};
  return scene;
}

TEST(MeanBeam, OfAFreshMeadowSwaysOnceOrTwiceASecond) {
  const scene::Scene scene;
  const wind::Beam beam = mean_beam(scene, 0.0, 0.0);
  // A strip of half a gigapascal that is folded to the depth d: E I / m = E d^2 / (12 rho).
  const double d = scene.grass.keel_depth_m, length_m = scene.grass.height_m;
  const double wanted = 3.516 / (2.0 * std::numbers::pi * length_m * length_m) *
                        std::sqrt(0.5e9 * d * d / (12.0 * 800.0));
  EXPECT_NEAR(wind::natural_frequency_hz(beam) / wanted, 1.0, 0.02);
  EXPECT_GT(wanted, 1.0);
  EXPECT_LT(wanted, 2.0);
}

TEST(MeanBeam, SnowSlowsItAndDryingChangesIt) {
  const scene::Scene scene;
  const double fresh_hz = wind::natural_frequency_hz(mean_beam(scene, 0.0, 0.0));
  const double snowy_hz = wind::natural_frequency_hz(mean_beam(scene, 0.0, 1.0));
  // 0.70 kg of snow on a square metre of leaf (snow_ridge.h), which weighs 0.16 kg.
  EXPECT_NEAR(snowy_hz / fresh_hz, 1.0 / std::sqrt(1.0 + 0.70 / 0.16), 0.02);
  const wind::Beam straw = mean_beam(scene, 1.0, 0.0);
  EXPECT_LT(straw.mass_kg_m, 0.5 * mean_beam(scene, 0.0, 0.0).mass_kg_m);
}

TEST(MeanBeam, IsTheMeanOfTheSpecies) {
  scene::Scene scene;
  scene.species.resize(2);
  scene.species[0].share = 3.0;
  scene.species[0].plant.height_m = 0.2;
  scene.species[1].plant.height_m = 0.6;
  EXPECT_NEAR(mean_beam(scene, 0.0, 0.0).length_m, 0.3, 1e-6);
  // Stalks of flowers do not wave the meadow.
  scene.species[1].flower.petals = 5;
  EXPECT_NEAR(mean_beam(scene, 0.0, 0.0).length_m, scene.species[0].plant.height_m, 1e-6);
  scene.species[0].flower.petals = 5;
  EXPECT_NEAR(mean_beam(scene, 0.0, 0.0).length_m, 0.3, 1e-6);
  // Nor do shrubs.
  scene.species[0].flower.petals = scene.species[1].flower.petals = 0;
  scene.species[1].plant.crown_m = 0.5;
  EXPECT_NEAR(mean_beam(scene, 0.0, 0.0).length_m, scene.species[0].plant.height_m, 1e-6);
}

TEST(WavingGrass, MovesFromFrameToFrameAndNeedsNoOtherFrame) {
  const scene::Scene scene = windy_scene();
  const place::Site site = test::site_of(scene);
  const glm::dvec2 at_m(10.0, 12.0);
  const glm::dvec2 third = frame_grass(scene, site, 3).wind_lean.lean(at_m);
  const glm::dvec2 first = frame_grass(scene, site, 1).wind_lean.lean(at_m);
  EXPECT_GT(glm::distance(first, third), 1e-3);
  EXPECT_EQ(frame_grass(scene, test::site_of(scene), 3).wind_lean.lean(at_m), third);
}

TEST(WavingGrass, StandsStillWhereItIsAskedToAndHairAlways) {
  scene::Scene scene = windy_scene();
  scene.wind.grass = scene::GrassMotion::still;
  EXPECT_EQ(test::site_of(scene).air, nullptr);
  scene.wind.grass = scene::GrassMotion::waving;
  scene.ageing.fur.clumps = 12;
  EXPECT_EQ(test::site_of(scene).air, nullptr);
}

// In still air waving grass stands as it has been combed.
TEST(WavingGrass, WithoutWindIsStill) {
  scene::Scene scene = windy_scene();
  scene.wind.speed_m_s = 0.0;
  const place::Site site = test::site_of(scene);
  const WindLean combed = test::grass_of(scene, 1).wind_lean;
  const WindLean waving = frame_grass(scene, site, 2).wind_lean;
  for (int i = 0; i < 20; ++i) {
    const glm::dvec2 at_m(1.0 * i, 24.0 - i);
    EXPECT_LT(glm::distance(waving.lean(at_m), combed.lean(at_m)), 1e-6);
  }
}

TEST(WavingGrass, LeansFurtherOnACrest) {
  scene::Scene scene = windy_scene();
  scene.wind.turbulence = 0.0;
  scene.wind.heading_deg = 45.0;
  place::Site site = test::site_of(scene);
  Heightfield ridge(65, 24.0);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i) {
      const double from_crest = (i + j - 64.0) * 24.0 / 64.0 / 4.0;
      ridge.at(i, j) = static_cast<float>(1.0 / (1.0 + from_crest * from_crest));
    }
  site.air = std::make_shared<const wind::AirFlow>(ridge, 0.32, 0.0, 1);
  const WindLean lean = frame_grass(scene, site, 1).wind_lean;
  EXPECT_GT(glm::length(lean.lean({12.0, 12.0})), 1.1 * glm::length(lean.lean({7.0, 7.0})));
}

/// The light on leaning grass, frame by frame: one dull upright fibre under a low sun behind the
/// wind.
ColourMap light_in(const scene::Scene& scene, const place::Site& site, int frame) {
  grass::Lighting sun;
  sun.sun_direction = glm::normalize(glm::dvec3(-1.0, 1.0, 1.0));
  sun.sun_irradiance = glm::vec3(0.8F);
  sun.sky_radiance.assign(grass::sky_size(), glm::vec3(0.1F));
  sun.eye_direction = {0.0, 0.0, 1.0};
  const LeanLight light({{glm::vec3(0, 0, 1), glm::vec3(0.3F), glm::vec3(0.1F), 0.2F}}, sun, 24.0F);
  const place::View view(place::resolved_camera(scene.camera, site.terrain, 0.0), 100, 100);
  return lean_light_map(light, frame_grass(scene, site, frame).wind_lean, site.terrain, view,
                        {{.size_m = scene.terrain.size_m}, 121});
}

/// How well two maps agree where the second is taken elsewhere: correlation of what differs from
/// the mean.
double agreement(const ColourMap& a, const ColourMap& b, const glm::dvec2& moved_m) {
  double n = 0.0, sum_a = 0.0, sum_b = 0.0, products = 0.0, squares_a = 0.0, squares_b = 0.0;
  for (double y = 4.0; y < 20.0; y += 0.4)
    for (double x = 4.0; x < 20.0; x += 0.4) {
      const double u = a.sample(x, y).g;
      const double v = b.sample(x + moved_m.x, y + moved_m.y).g;
      n += 1.0;
      sum_a += u;
      sum_b += v;
      products += u * v;
      squares_a += u * u;
      squares_b += v * v;
    }
  return (products - sum_a * sum_b / n) /
         std::sqrt((squares_a - sum_a * sum_a / n) * (squares_b - sum_b * sum_b / n));
}

// The film's brightness waves are gusts that come by: from the first frame to the third they go
// as far as the wind does.
TEST(WavingGrass, ItsBrightnessWavesTravelWithTheWind) {
  const scene::Scene scene = windy_scene();
  const place::Site site = test::site_of(scene);
  const ColourMap before = light_in(scene, site, 1), after = light_in(scene, site, 3);
  double best = -1.0;
  glm::dvec2 moved_m(0.0);
  for (double y = -1.2; y <= 1.2; y += 0.05)
    for (double x = -1.2; x <= 1.2; x += 0.05)
      if (const double now = agreement(before, after, {x, y}); now > best) {
        best = now;
        moved_m = {x, y};
      }
  EXPECT_GT(best, 0.9);  // waves as short as the map's steps do not fit in between
  EXPECT_NEAR(std::atan2(moved_m.x, moved_m.y) * 180.0 / std::numbers::pi, 135.0, 10.0);
  EXPECT_NEAR(glm::length(moved_m) * frames_per_s / 2.0 / 8.0, 1.0, 0.2);
}

}  // namespace
}  // namespace wold::meadow
