#include "sky/precipitation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "film/assemble.h"
#include "film/exporters.h"
#include "phenology/film_season.h"
#include "place/view.h"
#include "support/film_parts.h"
#include "support/no_grass.h"

namespace wold::sky {
namespace {

constexpr int width_px = 64, height_px = 36;

/// The default meadow's first frame, without grass and sky.
landscape::Landscape snowing(const scene::Scene& scene) {
  const place::Site site = test::site_of(scene);
  landscape::Landscape landscape;
  landscape.terrain = site.terrain;
  landscape.camera = place::resolved_camera(scene.camera, site.terrain, 0.0);
  landscape.width_px = width_px;
  landscape.height_px = height_px;
  landscape.sky = Image(8, 4, 3);
  const double extinction_per_m = falling_extinction_per_m(scene, site, 1);
  add_precipitation(scene, site, PrecipitationMedium(site.day, extinction_per_m, 0.2),
                    film::needs_of({}), landscape);
  return landscape;
}

scene::Scene snowy(scene::SnowfallStrength strength) {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 30.0;
  scene.terrain.samples = 33;
  scene.snowfall.strength = strength;
  scene.camera.eye_m = {15.0, 1.5};
  scene.camera.target_m = {15.0, 24.0};
  return scene;
}

/// How many flakes the ray through a pixel's middle passes.
int flakes_passed(const landscape::Landscape& landscape, int column, int row) {
  const landscape::Camera& camera = landscape.camera;
  const glm::dvec3 ahead = glm::normalize(camera.target_m - camera.eye_m);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.0, 0.0, 1.0)));
  const double pixel = 2.0 * std::tan(glm::radians(0.5 * camera.field_of_view_deg)) / width_px;
  const glm::dvec3 ray = ahead + pixel * ((column + 0.5 - 0.5 * width_px) * right +
                                          (0.5 * height_px - row - 0.5) * glm::cross(right, ahead));
  int passed = 0;
  for (const landscape::Flake& flake : landscape.flakes.flakes) {
    const glm::dvec3 across(flake.right_m), along(flake.up_m);
    const glm::dvec3 from_eye = glm::dvec3(flake.centre_m) - camera.eye_m;
    const glm::dvec3 normal = glm::cross(across, along);
    const glm::dvec3 hit = glm::dot(from_eye, normal) / glm::dot(ray, normal) * ray - from_eye;
    if (std::abs(glm::dot(hit, across)) <= glm::dot(across, across) &&
        std::abs(glm::dot(hit, along)) <= glm::dot(along, along))
      ++passed;
  }
  return passed;
}

TEST(SnowfallModel, HasTheSnowfallsExtinction) {
  scene::Scene scene = snowy(scene::SnowfallStrength::blizzard);
  const double extinction_per_m = falling_extinction_per_m(scene, test::site_of(scene), 1);
  EXPECT_NEAR(extinction_per_m, 2.49e-3 * std::pow(4.0, 1.05), 0.02 * extinction_per_m);
}

/// What falls above two degrees is streaks of rain in a fog, under a sky that greys.
TEST(SnowfallModel, IsRainWhereItIsWarm) {
  scene::Scene scene = snowy(scene::SnowfallStrength::weather);
  scene.weather.precipitation_mm_h = 8.0;
  scene.weather.temperature_c = 12.0;
  // Marshall and Palmer: pi N0 / (2 Lambda^3), by geometry alone.
  const double lambda = 4.1 * std::pow(8.0, -0.21);
  const double extinction_per_m = 1e-6 * 1.5708 * 8000.0 / std::pow(lambda, 3);
  EXPECT_NEAR(falling_extinction_per_m(scene, test::site_of(scene), 1), extinction_per_m,
              1e-3 * extinction_per_m);
  const landscape::Landscape rain = snowing(scene);
  for (const landscape::FlakePicture& picture : rain.flakes.pictures)
    EXPECT_TRUE(picture.name == "streak" || picture.name == "disc") << picture.name;
  EXPECT_GT(rain.flakes.flakes.size(), 15000u);  // of 30000 those above the ground
  EXPECT_LT(rain.flakes.flakes.size(), 31000u);
  ASSERT_TRUE(rain.fog);
  EXPECT_NEAR(rain.fog->extinction_per_m, extinction_per_m, 0.05 * extinction_per_m);
  // At one degree as much falls as snow as as rain.
  scene.weather.temperature_c = 1.0 + 1.6 * 0.0065;
  const landscape::Landscape sleet = snowing(scene);
  EXPECT_GT(sleet.flakes.pictures.size(), rain.flakes.pictures.size());
  EXPECT_GT(sleet.flakes.flakes.size(), rain.flakes.flakes.size());
}

/// Ten days of which the sixth, frame 6, has frost and all the precipitation.
scene::Scene one_snowy_day() {
  scene::Scene scene = snowy(scene::SnowfallStrength::weather);
  scene.season.first = {2026, 12, 1};
  scene.season.last = {2026, 12, 10};
  scene.season.frames = 10;
  scene.sun.time_h = 12.0;
  scene.season_keys = {{.date = {2026, 12, 1}, .weathering = 1.0, .temperature_c = -8.0},
                       {.date = {2026, 12, 5}, .precipitation_mm_day = 0.0},
                       {.date = {2026, 12, 6}, .precipitation_mm_day = 20.0},
                       {.date = {2026, 12, 7}, .precipitation_mm_day = 0.0}};
  return test::film_of(scene);
}

// The sky greys before a day's snow and clears after it, however sudden that is; flakes are its
// own.
TEST(SnowfallModel, OfOneDayGreysTheSkyGently) {
  const scene::Scene scene = one_snowy_day();
  const place::Site site = test::site_of(scene);
  double own = 0.0, greying = 0.0;
  for (int frame = 1; frame <= 10; ++frame) {
    own += falling_extinction_per_m(scene, site, frame);
    greying += overcast_extinction_per_m(scene, site, frame);
  }
  EXPECT_GT(own, 0.0);
  EXPECT_NEAR(greying, own, 1e-9);
  for (int frame = 2; frame <= 10; ++frame)
    EXPECT_LT(std::abs(overcast_extinction_per_m(scene, site, frame) -
                       overcast_extinction_per_m(scene, site, frame - 1)),
              0.25 * own);
  const auto shown = [&](int frame) {
    return film::assemble(scene, place::site_of_frame(scene, site, frame),
                          test::grass_of(scene, frame), {}, test::no_grass(), film::needs_of({}));
  };
  const landscape::Landscape clear = shown(1), before = shown(5), snowing = shown(6);
  const auto sun = [](const landscape::Landscape& landscape) {
    return landscape.daylight.sun_irradiance.g;
  };
  EXPECT_TRUE(before.flakes.flakes.empty());
  EXPECT_FALSE(before.fog);
  EXPECT_LT(sun(before), 0.9F * sun(clear));
  EXPECT_GT(snowing.flakes.flakes.size(), 100u);
  EXPECT_LT(sun(snowing), 0.5F * sun(before));
}

// A whirl of many faint flakes, as seen in a picture of few pixels, where POV-Ray would end.
TEST(SnowfallModel, HasNoMoreFlakesOnARayThanPovRayPasses) {
  scene::Scene scene = snowy(scene::SnowfallStrength::blizzard);
  scene.wind.field = scene::WindPattern::tornado;
  const landscape::Landscape landscape = snowing(scene);
  int max = 0;
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column)
      max = std::max(max, flakes_passed(landscape, column, row));
  EXPECT_LT(max, 240);
  EXPECT_GT(max, 100) << "not a whirl that was thinned";
  for (const landscape::Flake& flake : landscape.flakes.flakes) {
    EXPECT_LE(flake.opacity, 1.0F);
    EXPECT_LT(static_cast<std::size_t>(flake.picture), landscape.flakes.pictures.size());
  }
}

// Thinning whirls once thinned all snow.
TEST(SnowfallModel, HasAllFlakesThatAreAskedForWhereNoneAreTooMany) {
  scene::Scene scene = snowy(scene::SnowfallStrength::light);
  scene.snowfall.flakes = 100000;
  scene.camera.target_height_m = 9.0;  // nothing but sky
  EXPECT_NEAR(static_cast<double>(snowing(scene).flakes.flakes.size()), 100000.0, 3000.0);
}

}  // namespace
}  // namespace wold::sky
