#include "place/withering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/colour.h"
#include "meadow/film_lights.h"
#include "phenology/film_season.h"
#include "place/site.h"
#include "scene/sun_position.h"
#include "support/film_parts.h"

namespace wold::place {
namespace {

constexpr int middle = 51;  // of 101 frames

/// A film of 100 days in which the mean place withers by a hundredth a day.
scene::Scene even_season() {
  scene::Scene scene;
  scene.season.first = {2026, 8, 1};
  scene.season.last = {2026, 11, 9};
  scene.season.frames = 101;
  scene.season.spread_days = 0.0;
  scene.season.hollow_frost_k = 0.0;
  scene.sun.latitude_deg = 45.0;
  scene.season_keys = {{.date = {2026, 8, 1}, .weathering = 0.0},
                       {.date = {2026, 11, 9}, .weathering = 1.0}};
  return test::film_of(scene);
}

template <class Height>
Heightfield ground(const Height& height) {
  Heightfield terrain(129, 512.0);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) = static_cast<float>(height(terrain.place_m(i, j)));
  return terrain;
}

double days_between(const Withering& withering, const glm::dvec2& early, const glm::dvec2& late) {
  return 100.0 * (withering.at(early, middle) - withering.at(late, middle));
}

// Hopkins: four days for every 400 feet.
TEST(Withering, ComesEarlierOnHighGround) {
  const Withering withering =
      test::withering_of(even_season(), ground([](const glm::dvec2& at) { return 0.5 * at.x; }));
  EXPECT_NEAR(days_between(withering, {400.0, 256.0}, {400.0 - 2.0 * 121.92, 256.0}), 4.0, 1e-4);
  const auto [min, max] = withering.range(middle);
  EXPECT_LE(min, withering.at({0.0, 0.0}, middle));
  EXPECT_GE(max, withering.at({512.0, 0.0}, middle));
}

// A slope of 45 degrees that faces the sun of 45 degrees gets 1.414 times as much as level ground,
// one that faces away nothing: 10 days times the difference.
TEST(Withering, ComesEarlierOnSunnySlopes) {
  const Withering withering = test::withering_of(
      even_season(), ground([](const glm::dvec2& at) { return -std::abs(at.y - 256.0); }));
  EXPECT_NEAR(days_between(withering, {256.0, 128.0}, {256.0, 384.0}), 10.0 * std::sqrt(2.0), 1e-3);
}

// Half of what height would do whose air is as much colder: 2.52 days for each kelvin at night.
TEST(Withering, ComesEarlierInTheDeepestHollow) {
  const Heightfield pit = ground([](const glm::dvec2& at) {
    return -8.0 * std::exp(-glm::dot(at - 256.0, at - 256.0) / 2000.0);
  });
  scene::Scene scene = even_season();
  const double before = test::withering_of(scene, pit).at({256.0, 256.0}, middle);
  scene.season.hollow_frost_k = 4.0;
  const Withering frosty = test::withering_of(scene, pit);
  EXPECT_NEAR(100.0 * (frosty.at({256.0, 256.0}, middle) - before),
              4.0 * 0.5 * 4.0 / 121.92 / 0.0065, 1e-3);
  EXPECT_NEAR(frosty.at({30.0, 30.0}, middle), 0.5, 0.01);  // far away from it, level
}

// The soil's days have the deviation that was asked for; nothing gets greener, all of it withers.
TEST(Withering, SoilSpreadsItAndItNeverGoesBack) {
  scene::Scene scene = even_season();
  scene.season.spread_days = 6.0;
  scene.ageing.age_spread_feature_m = 5.0;
  const Withering withering =
      test::withering_of(scene, ground([](const glm::dvec2&) { return 0.0; }));
  double sum = 0.0, squares = 0.0;
  int places = 0;
  for (double x = 3.0; x < 510.0; x += 11.0)
    for (double y = 3.0; y < 510.0; y += 11.0, ++places) {
      const double days = 100.0 * (withering.at({x, y}, middle) - 0.5);
      sum += days;
      squares += days * days;
      EXPECT_GE(withering.at({x, y}, middle + 1), withering.at({x, y}, middle));
    }
  EXPECT_NEAR(sum / places, 0.0, 0.5);
  EXPECT_NEAR(std::sqrt(squares / places), 6.0, 0.5);
}

// The sun of a season's frame stands where it does on that day, and grass is baked for steps of at
// most 10 degrees between the first day's and the last's.
TEST(SiteOfFrame, HasTheDaysLight) {
  scene::Scene scene = even_season();
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 33;
  scene.camera.eye_m = {4.0, 0.5};
  scene.camera.target_m = {4.0, 6.0};
  scene.season_keys[0].visual_range_m = 5e3;
  const Site site = test::site_of(scene);
  for (const int frame : {1, 51, 101}) {
    const auto date =
        std::chrono::sys_days(scene::date_of(scene.season.first)) + std::chrono::days(frame - 1);
    const scene::SunPosition sun = scene::sun_position(
        date, scene.sun.time_h, scene.sun.latitude_deg, scene.sun.longitude_deg);
    const glm::dvec3 direction = site_of_frame(scene, site, frame).day.sun_direction();
    EXPECT_NEAR(std::asin(direction.z), glm::radians(sun.elevation_deg), 1e-9);
    EXPECT_NEAR(site_of_frame(scene, site, frame).day.visual_range_m(), 5e3, 1e-6);
  }
  const auto lights = meadow::film_lights(scene, site);
  ASSERT_EQ(static_cast<int>(lights.size()), meadow::light_count(scene));
  EXPECT_EQ(meadow::light_of_frame(scene, 101), meadow::light_count(scene) - 1.0);
  for (std::size_t i = 1; i < lights.size(); ++i)
    EXPECT_LT(
        glm::degrees(std::acos(glm::dot(lights[i - 1].sun_direction, lights[i].sun_direction))),
        12.0);
  EXPECT_EQ(meadow::frame_lighting(scene, site, 1).sun_direction, lights.front().sun_direction);
}

// In a year the noon sun climbs by 47 degrees and sinks again: 94 degrees, of 10 each. Counted
// once, light would change by 18 degrees from one to the next, and single cells would stand out.
TEST(SiteOfFrame, HasLightsForTheSunsWayUpAndDownInAYear) {
  scene::Scene scene = even_season();
  scene.season.first = {2025, 12, 21};
  scene.season.last = {2026, 12, 21};
  scene.sun.latitude_deg = 45.0;
  scene.sun.longitude_deg = 0.0;
  scene.sun.time_h = 12.0;
  EXPECT_EQ(meadow::light_count(scene), 11);
}

// A sun that sets within a film lights each frame from where it stands, and grass is baked for its
// way in steps of 10 degrees at most: here 24 to the west and 20 down are 31.
TEST(SiteOfFrame, HasTheLightOfASettingSun) {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 33;
  scene.camera.eye_m = {4.0, 0.5};
  scene.camera.target_m = {4.0, 6.0};
  scene.ageing.frames = {0.0, 0.0, 0.0};
  scene.sun.elevation_deg = 22.0;
  scene.sun.azimuth_deg = 260.0;
  scene.sun.end = {2.0, 284.0};
  const Site site = test::site_of(scene);
  const Site half_way = site_of_frame(scene, site, 2);
  EXPECT_NEAR(std::asin(half_way.day.sun_direction().z), glm::radians(12.0), 1e-9);
  EXPECT_EQ(meadow::light_count(scene), 5);
  EXPECT_EQ(meadow::light_of_frame(scene, 2), 2.0);
  const auto lights = meadow::film_lights(scene, site);
  EXPECT_NEAR(lights.back().sun_direction.z, std::sin(glm::radians(2.0)), 1e-6);
  const auto lit = [&](int frame) {
    return luminance(site_of_frame(scene, site, frame).light.sun.sample(4.0, 4.0));
  };
  EXPECT_GT(lit(1), lit(2));
  EXPECT_GT(lit(2), lit(3));
}

// Light changes fast while the sun sets: steps are of 4 degrees at most.
TEST(SiteOfFrame, HasMoreLightsWhereTheSunSets) {
  scene::Scene scene;
  scene.ageing.frames = {0.0, 0.0};
  scene.sun.elevation_deg = 8.0;
  scene.sun.end = {0.0, scene.sun.azimuth_deg};
  EXPECT_EQ(meadow::light_count(scene), 2);
  scene.sun.end = {-4.0, scene.sun.azimuth_deg};
  EXPECT_EQ(meadow::light_count(scene), 4);
}

class FilmLights : public testing::TestWithParam<double> {};

// However few frames and however much snow falls, every light is one: of unit irradiance, as baked
// grass has it.
TEST_P(FilmLights, OfTwoFramesAreLights) {
  scene::Scene scene = even_season();
  scene.season.frames = 2;
  scene.weather.precipitation_mm_h = GetParam();
  scene.weather.temperature_c = -5.0;
  scene = test::film_of(scene);
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 33;
  scene.camera.eye_m = {4.0, 0.5};
  scene.camera.target_m = {4.0, 6.0};
  const auto lights = meadow::film_lights(scene, test::site_of(scene));
  ASSERT_GT(lights.size(), 2u);
  for (const grass::Lighting& lighting : lights) {
    glm::vec3 sum = lighting.sun_irradiance * static_cast<float>(lighting.sun_direction.z);
    for (const grass::SkyDirection& sky : grass::sky_directions(lighting))
      sum += sky.irradiance() * static_cast<float>(sky.direction.z);
    EXPECT_NEAR(sum.g, 1.0F, 1e-4F);
  }
}

INSTANTIATE_TEST_SUITE_P(InHeavyAndLightSnow, FilmLights, testing::Values(1.0, 0.01));

/// Mean square difference of degrees of places `apart_m` from each other.
double variogram(const Withering& withering, double apart_m) {
  constexpr int places = 120;
  constexpr double step_m = 3.7;
  double sum = 0.0;
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * step_m;
      const double apart = withering.at(at_m, 1) - withering.at(at_m + glm::dvec2(apart_m, 0.0), 1);
      sum += apart * apart;
    }
  return sum / (places * places);
}

// Places of one size, as a small meadow has them, would cover a wide one like a camouflage cloth.
TEST(Withering, HasPlacesOfAllSizesOnAWideTerrain) {
  scene::Scene scene;
  scene.ageing.frames = {0.5};
  const Heightfield level = ground([](const glm::dvec2&) { return 0.0; });
  const auto growth = [&](double size_m) {
    scene.terrain.size_m = size_m;
    const Withering withering = test::withering_of(scene, level);
    return variogram(withering, 40.0) / variogram(withering, 8.0);
  };
  EXPECT_NEAR(growth(42.0), 1.0, 0.15);
  EXPECT_GT(growth(512.0), 1.3);
}

}  // namespace
}  // namespace wold::place
