#include "light/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "light/air_columns.h"

namespace wold::light {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// Of the air that Gillette measured under, with an extinction of 0.21 per air mass; very clear;
/// with about 2.75 times the extinction of molecules, as Krochmann and Seidl had it.
constexpr double of_gillette = 1.8, very_clear = 2.2, clear = 2.5;

/// Luminance of the clear sky, as linear sRGB, by degrees of elevation and of azimuth from the sun.
glm::dvec3 sky_at(const Atmosphere& air, double sun_deg, double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * degree, s = sun_deg * degree, a = azimuth_deg * degree;
  const double cosine = std::sin(e) * std::sin(s) + std::cos(e) * std::cos(s) * std::cos(a);
  return air.sky_kcd_m2(e, a, cosine);
}

/// Of level ground, by the sky alone.
double sky_illuminance_klx(const Atmosphere& air, double sun_deg) {
  double sum = 0.0;
  for (double e = 0.5; e < 90.0; e += 1.0)
    for (double a = 1.5; a < 180.0; a += 3.0)
      sum += luminance(sky_at(air, sun_deg, e, a)) * std::sin(e * degree) * std::cos(e * degree);
  return sum * degree * 3.0 * degree * 2.0;
}

double x_of(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = xyz_from_srgb(rgb);
  return xyz.x / (xyz.x + xyz.y + xyz.z);
}

// Kasten and Young 1989 (with refraction, which is 3 % at the horizon): air masses.
TEST(AirColumns, HaveTheAirMassesOfTables) {
  const AirColumns columns;
  const double upward_m = columns.to_space_m(0.0, 1.0)->molecules;
  EXPECT_NEAR(upward_m, 8000.0, 8.0);
  for (const auto& [elevation_deg, mass] :
       {std::pair(60.0, 1.154), {30.0, 1.994}, {10.0, 5.586}, {5.0, 10.31}})
    EXPECT_NEAR(columns.to_space_m(0.0, std::sin(elevation_deg * degree))->molecules / upward_m,
                mass, 0.02 * mass)
        << elevation_deg;
  // Chapman 1931: of an exponential air sqrt(pi R / 2 H) at the horizon.
  EXPECT_NEAR(columns.to_space_m(0.0, 0.0)->molecules / upward_m,
              std::sqrt(0.5 * std::numbers::pi * ground_radius_m / 8000.0), 0.4);
}

TEST(AirColumns, EndAtTheGround) {
  const AirColumns columns;
  EXPECT_FALSE(columns.to_space_m(0.0, -0.01));
  EXPECT_TRUE(columns.to_space_m(30000.0, -0.05));
  EXPECT_FALSE(columns.to_space_m(30000.0, -0.15));
}

// Gillette, Pierpoint and Treado 1984: level ground under a clear sky has 128 klx exp(-0.21 / s) s
// of the sun, s the sine of its elevation, and 0.8 + 15.5 s^0.5 klx of the sky.
TEST(Atmosphere, GivesTheGroundWhatWasMeasured) {
  for (const double sun_deg : {15.0, 30.0, 45.0, 60.0, 80.0}) {
    const Atmosphere air(sun_deg * degree, of_gillette);
    const double s = std::sin(sun_deg * degree);
    const double sun_klx = luminance(air.sun_klx()) * s,
                 sky_klx = sky_illuminance_klx(air, sun_deg);
    const double measured_sun_klx = 128.0 * std::exp(-0.21 / s) * s;
    const double measured_sky_klx = 0.8 + 15.5 * std::sqrt(s);
    EXPECT_NEAR(sun_klx, measured_sun_klx, 0.1 * measured_sun_klx) << sun_deg;
    EXPECT_NEAR(sky_klx, measured_sky_klx, 0.1 * measured_sky_klx) << sun_deg;
    EXPECT_NEAR(sun_klx + sky_klx, measured_sun_klx + measured_sky_klx,
                0.05 * (measured_sun_klx + measured_sky_klx))
        << sun_deg;
  }
}

// Krochmann and Seidl 1974, Quantitative data on daylight for illuminating engineering: of the
// clear sky's zenith 0.3 + 3 tan(elevation of the sun), kcd/m2.
TEST(Atmosphere, HasTheZenithThatWasMeasured) {
  for (const double sun_deg : {15.0, 20.0, 30.0, 45.0, 60.0}) {
    const Atmosphere air(sun_deg * degree, clear);
    const double measured = 0.3 + 3.0 * std::tan(sun_deg * degree);
    EXPECT_NEAR(luminance(sky_at(air, sun_deg, 90.0, 0.0)), measured, 0.1 * measured) << sun_deg;
  }
}

// A clear day's end: 400 lx when the sun's upper limb sets, 3.4 lx at the end of civil twilight
// (U.S. Naval Observatory).
TEST(Atmosphere, DimsAtDuskAsItDoes) {
  const auto lux = [](double sun_deg) {
    return 1000.0 * sky_illuminance_klx(Atmosphere(sun_deg * degree, clear), sun_deg);
  };
  EXPECT_NEAR(std::log2(lux(-0.83) / 400.0), 0.0, 0.6);
  EXPECT_NEAR(std::log2(lux(-6.0) / 3.4), 0.0, 0.8);
  EXPECT_EQ(luminance(Atmosphere(-1.0 * degree, clear).sun_klx()), 0.0);
}

// The disc is half a degree wide: while it sets its light goes evenly, and half of it is seen when
// its middle stands on the horizon.
TEST(Atmosphere, LosesTheSunAsItsDiscSets) {
  const auto klx = [](double sun_deg) {
    return luminance(sunlight_klx(sun_deg * degree, very_clear));
  };
  EXPECT_EQ(klx(-0.27), 0.0);
  EXPECT_GT(klx(-0.2), 0.0);
  EXPECT_NEAR(klx(0.0) / klx(0.2665), 0.17, 0.05);  // the upper half, in more air
  for (double sun_deg = -0.3; sun_deg < 1.0; sun_deg += 0.02) {
    EXPECT_GE(klx(sun_deg + 0.02), klx(sun_deg)) << sun_deg;
    EXPECT_LT(klx(sun_deg + 0.02) - klx(sun_deg), 0.08 * klx(1.0)) << sun_deg;
  }
}

// The sun's own colour: about 5,000 to 5,700 K when it is high (CIE D50 has x 0.3457, D55 0.3324),
// redder the lower it stands.
TEST(Atmosphere, ReddensTheSunTowardsTheHorizon) {
  EXPECT_NEAR(x_of(sunlight_klx(60.0 * degree, clear)), 0.342, 0.01);
  double before = 0.0;
  for (const double sun_deg : {90.0, 40.0, 20.0, 10.0, 5.0, 2.0}) {
    const double x = x_of(sunlight_klx(sun_deg * degree, clear));
    EXPECT_GT(x, before) << sun_deg;
    before = x;
  }
}

// Over a sun that has set the sky goes from red through yellow to the blue of the zenith, which
// ozone keeps (Hulburt 1953); by day it is blue, most at right angles to the sun.
TEST(Atmosphere, HasTheOrderOfTwilightsColours) {
  const Atmosphere dusk(-3.0 * degree, very_clear);
  double before = 1.0;
  for (const double elevation_deg : {3.0, 6.0, 12.0, 25.0, 60.0}) {
    const double x = x_of(sky_at(dusk, -3.0, elevation_deg, 0.0));
    EXPECT_LT(x, before) << elevation_deg;
    before = x;
  }
  EXPECT_GT(x_of(sky_at(dusk, -3.0, 3.0, 0.0)), 0.36);
  EXPECT_LT(x_of(sky_at(dusk, -3.0, 60.0, 0.0)), 0.27);
  EXPECT_LT(x_of(sky_at(Atmosphere(30.0 * degree, clear), 30.0, 60.0, 180.0)), 0.27);
}

// No line anywhere: brightness changes evenly from the horizon up, without steps.
TEST(Atmosphere, HasNoBands) {
  for (const double sun_deg : {-2.0, 0.5, 3.0, 12.0, 50.0}) {
    const Atmosphere air(sun_deg * degree, 3.0);
    for (const double azimuth_deg : {20.0, 60.0, 180.0}) {
      const auto stops = [&](double elevation_deg) {
        return std::log2(luminance(sky_at(air, sun_deg, elevation_deg, azimuth_deg)));
      };
      for (double e = 0.25; e < 89.0; e += 0.25)
        EXPECT_NEAR(stops(e - 0.25) + stops(e + 0.25), 2.0 * stops(e), 0.06)
            << sun_deg << " " << azimuth_deg << " " << e;
    }
  }
}

}  // namespace
}  // namespace wold::light
