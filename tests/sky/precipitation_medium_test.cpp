#include "sky/precipitation_medium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/colour.h"

namespace wold::sky {
namespace {

constexpr double pi = std::numbers::pi;

light::Daylight noon() { return {scene::Sun{}, scene::Sky{}}; }

// An integral over the hemisphere, by bands.
glm::dvec3 irradiance(const PrecipitationMedium& air) {
  constexpr int bands = 200;
  glm::dvec3 sum(0.0);
  for (int b = 0; b < bands; ++b) {
    const double elevation = (b + 0.5) * 0.5 * pi / bands;
    const glm::dvec3 radiance = air.sky_radiance(
        glm::vec3(0.0F), glm::dvec3(std::cos(elevation), 0.0, std::sin(elevation)));
    sum += radiance * (std::sin(elevation) * std::cos(elevation) * 2.0 * pi * 0.5 * pi / bands);
  }
  return sum;
}

TEST(PrecipitationMedium, WithoutSnowIsClear) {
  const light::Daylight day = noon();
  const PrecipitationMedium air(day, 0.0, 0.2);
  EXPECT_EQ(air.sunlit_fraction(), 1.0);
  const ColourMap light(3, 1.0, glm::vec3(0.7F, 0.8F, 0.9F));
  EXPECT_EQ(air.light(light, FactorMap(3, 1.0, 0.9F)).at(1, 1), light.at(1, 1));
  EXPECT_EQ(air.sky_radiance(glm::vec3(0.3F), {0.0, 0.0, 1.0}), glm::vec3(0.3F));
}

// What is said to fall on level ground is what the sky that is seen sends, over ground so dark that
// the snow's glow is that of the sky alone.
TEST(PrecipitationMedium, ThickSnowLightsTheGroundAsItsSkyDoes) {
  const light::Daylight day = noon();
  const PrecipitationMedium air(day, 0.01, 0.0);
  EXPECT_LT(air.sunlit_fraction(), 1e-10);
  const ColourMap clear(2, 1.0, glm::vec3(1.0F));
  const glm::vec3 light = air.light(clear, FactorMap(2, 1.0, 1.0F)).at(0, 0);
  const glm::dvec3 seen = irradiance(air);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / double{light[c]}, 1.0, 0.02);
  EXPECT_GT(light.b, light.r);
}

// A camera opens up under snow clouds: level ground is hardly darker than its white, day and dusk.
TEST(PrecipitationMedium, LeavesALittleOfTheGloom) {
  for (const double elevation_deg : {50.0, 3.0}) {
    scene::Sun sun;
    sun.elevation_deg = elevation_deg;
    const light::Daylight day(sun, scene::Sky{});
    const ColourMap none(2, 1.0, glm::vec3(0.0F));
    const glm::vec3 light =
        PrecipitationMedium(day, 0.01, 0.3).light(none, FactorMap(2, 1.0, 1.0F)).at(0, 0);
    EXPECT_GT(luminance(light), 0.9);
    EXPECT_LT(luminance(light), 1.0);
  }
}

TEST(PrecipitationMedium, SunAndClearSkyFadeByBeersLaw) {
  const light::Daylight day = noon();
  const double sine = day.sun_direction().z;
  EXPECT_NEAR(PrecipitationMedium(day, 1e-4, 0.2).sunlit_fraction(), std::exp(-0.3 / sine), 1e-12);
}

// A brighter ground makes the air glow: half of it, over black the mean of the sky.
TEST(PrecipitationMedium, GlowsWithTheGround) {
  const light::Daylight day = noon();
  const glm::vec3 over_black = PrecipitationMedium(day, 0.01, 0.0).radiance();
  const glm::vec3 over_white = PrecipitationMedium(day, 0.01, 1.0).radiance();
  EXPECT_NEAR(over_white.g / over_black.g, 1.0 + 7.0 / 6.0, 1e-4);
}

// Behind fog stands what leaves the sky that is wanted: Beer and Lambert from the eye to the
// rectangle and back.
TEST(PrecipitationMedium, IsSeenThroughItsFog) {
  const light::Daylight day = noon();
  const PrecipitationMedium air(day, 0.002, 0.4);
  const landscape::Fog fog{0.002, air.radiance()};
  landscape::Landscape landscape;
  landscape.camera.eye_m = {1.0, 2.0, 3.0};
  landscape.sky = Image(8, 4, 3);
  landscape.backdrop = landscape::Backdrop{
      Image(6, 4, 3), {-200.0, 300.0, 0.0}, {400.0, 0.0, 0.0}, {0.0, 0.0, 250.0}};
  show_through(air, fog, landscape);
  const landscape::Backdrop& backdrop = *landscape.backdrop;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 6; ++c) {
      const glm::dvec3 way_m = backdrop.corner_m + backdrop.right_m * ((c + 0.5) / 6.0) +
                               backdrop.up_m * (1.0 - (r + 0.5) / 4.0) - landscape.camera.eye_m;
      const double through = std::exp(-0.002 * glm::length(way_m));
      const glm::vec3 wanted = air.sky_radiance(glm::vec3(0.0F), glm::normalize(way_m));
      for (int channel = 0; channel < 3; ++channel) {
        const double seen = through * double{backdrop.picture.pixel(c, r)[channel]} +
                            (1.0 - through) * double{fog.radiance[channel]};
        EXPECT_NEAR(seen, double{wanted[channel]}, 1e-5);
      }
    }
}

}  // namespace
}  // namespace wold::sky
