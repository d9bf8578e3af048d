#include "light/water_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "light/daylight.h"

namespace wold::light {
namespace {

using std::numbers::pi;

double reflectance_at(double angle_deg) { return water_reflectance(std::cos(radians(angle_deg))); }

// By hand from Fresnel's equations for n = 1.333; at Brewster's angle, whose tangent is n, what
// swings in the plane of the rays is not reflected at all.
TEST(WaterSurface, ReflectsAsFresnelSays) {
  EXPECT_NEAR(reflectance_at(0.0), std::pow(0.333 / 2.333, 2), 1e-9);
  EXPECT_NEAR(reflectance_at(60.0), 0.0597, 1e-4);
  EXPECT_NEAR(reflectance_at(85.0), 0.5835, 1e-4);
  EXPECT_NEAR(reflectance_at(90.0), 1.0, 1e-9);
  const double brewster = std::atan(1.333), n2 = 1.333 * 1.333;
  const double across = (1.0 - n2) / (1.0 + n2);  // sin(b - t) / sin(b + t) with b + t = 90 degrees
  EXPECT_NEAR(reflectance_at(degrees(brewster)), 0.5 * across * across, 1e-9);
}

// The mean square slope that Cox and Munk give for all directions together is 0.003 + 5.12e-3 w.
TEST(WaterSurface, IsAsRoughAsCoxAndMunkMeasured) {
  for (const double wind_m_s : {1.0, 5.0, 14.0}) {
    const SlopeVariance variance = slope_variance(wind_m_s);
    EXPECT_NEAR(variance.along + variance.across, 0.003 + 5.12e-3 * wind_m_s,
                0.02 * (0.003 + 5.12e-3 * wind_m_s));
    EXPECT_EQ(variance.along > variance.across, wind_m_s > 2.5);
  }
}

TEST(WaterSurface, IsRoughestAlongTheWind) {
  const WaterFacets facets({0.04, 0.01}, {0.6, 0.8});
  EXPECT_NEAR(facets.deviation({0.6, 0.8}), 0.2, 1e-12);
  EXPECT_NEAR(facets.deviation({-0.8, 0.6}), 0.1, 1e-12);
}

TEST(WaterSurface, TheSunsGlitterIsBrightestWhereAMirrorShowsTheSun) {
  const WaterFacets facets(slope_variance(0.5), {0.6, 0.8});
  const glm::dvec3 to_sun = direction_of(radians(130.0), radians(50.0));
  double brightest = 0.0;
  glm::dvec3 at{0.0};
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 1.0)
    for (double elevation = 20.0; elevation < 90.0; elevation += 1.0) {
      const glm::dvec3 to_eye = direction_of(radians(azimuth), radians(elevation));
      const double glitter = facets.glitter(to_eye, to_sun);
      if (glitter <= brightest) continue;
      brightest = glitter;
      at = to_eye;
    }
  EXPECT_GT(glm::dot(at, glm::dvec3(-to_sun.x, -to_sun.y, to_sun.z)), std::cos(radians(4.0)));
}

// All that facets reflect of the sun goes somewhere: together with the part that water takes in it
// is what falls on it.
TEST(WaterSurface, TheGlittersSumIsTheSunsReflectance) {
  const WaterFacets facets(slope_variance(1.0), {1.0, 0.0});
  constexpr double sun_deg = 50.0, step_deg = 0.5;
  const glm::dvec3 to_sun = direction_of(0.3, radians(sun_deg));
  double flux = 0.0;
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += step_deg)
    for (double elevation = 0.5 * step_deg; elevation < 90.0; elevation += step_deg) {
      const glm::dvec3 to_eye = direction_of(radians(azimuth), radians(elevation));
      const double solid_angle = std::cos(radians(elevation)) * std::pow(radians(step_deg), 2);
      flux += facets.glitter(to_eye, to_sun) * to_eye.z * solid_angle;
    }
  const double expected = reflectance_at(90.0 - sun_deg) * to_sun.z;
  EXPECT_NEAR(flux, expected, 0.05 * expected);
}

TEST(WaterSurface, DoesNotGlitterWithoutASun) {
  const WaterFacets facets(slope_variance(5.0), {1.0, 0.0});
  EXPECT_EQ(facets.glitter({0.0, 0.6, 0.8}, direction_of(0.0, radians(-2.0))), 0.0);
}

TEST(WaterSurface, TiltedFacetsTurnTheirGlitterByTwiceTheTilt) {
  const WaterFacets facets({1e-4, 1e-4}, {1.0, 0.0});
  const glm::dvec3 to_sun(0.0, 0.0, 1.0);
  const double tilt_rad = radians(5.0);
  const glm::dvec2 tilt(0.0, -std::tan(tilt_rad));  // the water falls to the north and faces it
  EXPECT_GT(facets.glitter(direction_of(0.0, pi / 2.0 - 2.0 * tilt_rad), to_sun, tilt),
            1e3 * facets.glitter(direction_of(0.0, pi / 2.0), to_sun, tilt));
}

}  // namespace
}  // namespace wold::light
