#include "light/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "light/air.h"
#include "light/air_columns.h"
#include "light/white_balance.h"

namespace wold::light {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// Of the air that Gillette measured under, with an extinction of 0.21 per air mass; very clear;
/// with 2.75 times the extinction of molecules, ozone's among it, as Krochmann and Seidl had it.
constexpr double of_gillette = 1.8, very_clear = 2.2, clear = 2.4;

/// Luminance of the clear sky, as linear sRGB, by degrees of elevation and of azimuth from the sun.
glm::dvec3 sky_at(const Atmosphere& air, double sun_deg, double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * degree, s = sun_deg * degree, a = azimuth_deg * degree;
  const double cosine = std::sin(e) * std::sin(s) + std::cos(e) * std::cos(s) * std::cos(a);
  return air.sky_kcd_m2(e, a, cosine);
}

/// Of level ground, by the sky alone, as linear sRGB.
glm::dvec3 sky_klx(const Atmosphere& air, double sun_deg) {
  glm::dvec3 sum(0.0);
  for (double e = 0.5; e < 90.0; e += 1.0)
    for (double a = 1.5; a < 180.0; a += 3.0)
      sum += sky_at(air, sun_deg, e, a) * (std::sin(e * degree) * std::cos(e * degree));
  return sum * (degree * 3.0 * degree * 2.0);
}

double sky_illuminance_klx(const Atmosphere& air, double sun_deg) {
  return luminance(sky_klx(air, sun_deg));
}

/// The sun's elevation as it is seen from the ground where it would stand at this one without air.
double seen_deg(const AirColumns& columns, double without_air_deg) {
  double seen = without_air_deg;
  for (int i = 0; i < 20; ++i)
    seen += without_air_deg - columns.elevation_without_air_rad(seen * degree) / degree;
  return seen;
}

double x_of(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = xyz_from_srgb(rgb);
  return xyz.x / (xyz.x + xyz.y + xyz.z);
}

// Kasten and Young 1989 (with refraction, which is 3 % at the horizon): air masses.
TEST(AirColumns, HaveTheAirMassesOfTables) {
  const AirColumns columns;
  const double upward_m = columns.to_space_m(0.0, 1.0)->molecules;
  EXPECT_NEAR(upward_m, 10332.0 / 1.225, 42.0);  // kg/m2 of air at 101 325 Pa, over its density
  for (const auto& [elevation_deg, mass] :
       {std::pair(60.0, 1.154), {30.0, 1.994}, {10.0, 5.586}, {5.0, 10.31}})
    EXPECT_NEAR(columns.to_space_m(0.0, std::sin(elevation_deg * degree))->molecules / upward_m,
                mass, 0.02 * mass)
        << elevation_deg;
  // Chapman 1931: of an exponential air sqrt(pi R / 2 H) at the horizon.
  EXPECT_NEAR(columns.to_space_m(0.0, 0.0)->background / columns.to_space_m(0.0, 1.0)->background,
              std::sqrt(0.5 * std::numbers::pi * ground_radius_m / 8000.0), 0.4);
}

// U.S. Standard Atmosphere 1976, tables between those heights that the program has.
TEST(AirColumns, AreOfTheStandardAtmosphere) {
  for (const auto& [height_m, density] :
       {std::pair(2000.0, 1.0066), {8000.0, 0.52579}, {18000.0, 0.12165}, {32000.0, 0.013555}})
    EXPECT_NEAR(1.225 * air_at(height_m).molecules, density, 0.03 * density) << height_m;
}

// Bennett 1982: refraction by the elevation that is seen, in minutes of arc. That along a straight
// way is less at the horizon.
TEST(AirColumns, BendTheSunsLight) {
  const AirColumns columns;
  for (const auto& [seen_deg, minutes] :
       {std::pair(0.0, 34.5), {1.0, 24.3}, {2.0, 18.2}, {5.0, 9.9}, {10.0, 5.4}, {45.0, 1.0}})
    EXPECT_NEAR(60.0 * (seen_deg - columns.elevation_without_air_rad(seen_deg * degree) / degree),
                minutes, 0.12 * minutes + 0.1)
        << seen_deg;
  // What is seen goes on evenly as the sun sets.
  for (double deg = -5.0; deg < 0.5; deg += 0.1)
    EXPECT_NEAR((columns.elevation_without_air_rad((deg + 0.1) * degree) -
                 columns.elevation_without_air_rad(deg * degree)) /
                    degree,
                0.1, 0.06)
        << deg;
}

// The sun shines on a place for as long as its refracted light passes over the ground; grazing
// light spreads, most of all the lowest.
TEST(AirColumns, LetTheSunsLightGrazeTheGround) {
  const AirColumns columns;
  EXPECT_TRUE(columns.from_sun(0.0, std::sin(-0.5 * degree)));
  EXPECT_FALSE(columns.from_sun(0.0, std::sin(-0.7 * degree)));
  const double dip_rad = std::acos(ground_radius_m / (ground_radius_m + 30000.0));
  EXPECT_TRUE(columns.from_sun(30000.0, -std::sin(dip_rad + 1.0 * degree)));
  EXPECT_FALSE(columns.from_sun(30000.0, -std::sin(dip_rad + 1.3 * degree)));
  const auto brightness = [&](double below_rad) {
    return columns.from_sun(30000.0, -std::sin(below_rad))->brightness;
  };
  EXPECT_NEAR(brightness(0.0), 1.0, 0.02);
  EXPECT_LT(brightness(dip_rad), 0.95);
  EXPECT_LT(brightness(dip_rad + 0.6 * degree), brightness(dip_rad));
}

// Mie scattering of OPAC's average continental aerosol (Hess, Koepke and Schult 1998: water-soluble
// at 80 % of humidity, insoluble and soot, radii, widths and refractive indices as there) at 550
// nm: degrees and 1/sr. Its asymmetry is 0.703 there, too.
TEST(Aerosol, ScattersAsThatOfTables) {
  for (const auto& [angle_deg, per_sr] : {std::pair(0.5, 5.299),
                                          {1.0, 3.751},
                                          {2.0, 2.188},
                                          {5.0, 1.273},
                                          {10.0, 0.935},
                                          {20.0, 0.543},
                                          {30.0, 0.305},
                                          {40.0, 0.172}})
    EXPECT_NEAR(aerosol_phase(std::cos(angle_deg * degree)), per_sr, 0.08 * per_sr) << angle_deg;
  for (const auto& [angle_deg, per_sr] : {std::pair(0.0, 6.158),
                                          {60.0, 0.0594},
                                          {90.0, 0.0176},
                                          {120.0, 0.0104},
                                          {150.0, 0.0130},
                                          {180.0, 0.0168}})
    EXPECT_NEAR(aerosol_phase(std::cos(angle_deg * degree)), per_sr, 0.24 * per_sr) << angle_deg;
  double all = 0.0, forward = 0.0, second = 0.0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double cosine = -1.0 + (i + 0.5) * 2.0 / steps;
    const double part = aerosol_phase(cosine) * 4.0 * std::numbers::pi / steps;
    all += part;
    forward += part * cosine;
    second += part * 0.5 * (3.0 * cosine * cosine - 1.0);
  }
  EXPECT_NEAR(all, 1.0, 1e-3);
  EXPECT_NEAR(forward, 0.703, 0.005);
  EXPECT_NEAR(second, forward_fraction, 0.002);
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

// Colours of the sun's light, of the sky's on level ground and of both: correlated colour
// temperatures by SPCTRAL2 (Bird and Riordan 1986, fitted to measured spectra) with an optical
// depth of 0.171 of aerosol at 500 nm, which is that of a turbidity of 2.5, its exponent 1.3, 300
// Dobson units of ozone, 15 mm of water vapour, ground of albedo 0.2, and the CIE 1931 observer.
TEST(Atmosphere, HasTheColoursOfMeasuredSpectra) {
  struct Row {
    double sun_deg, sun_K, sky_K, both_K;
  };
  for (const Row& row : {Row{60.0, 5208.0, 9965.0, 5789.0}, Row{45.0, 5067.0, 9696.0, 5728.0},
                         Row{30.0, 4780.0, 9253.0, 5612.0}, Row{20.0, 4398.0, 8832.0, 5495.0},
                         Row{10.0, 3565.0, 8497.0, 5574.0}}) {
    const Atmosphere air(row.sun_deg * degree, 2.5);
    const glm::dvec3 sun = air.sun_klx() * std::sin(row.sun_deg * degree);
    const glm::dvec3 sky = sky_klx(air, row.sun_deg);
    EXPECT_NEAR(colour_temperature_K(sun), row.sun_K, 0.02 * row.sun_K) << row.sun_deg;
    EXPECT_NEAR(colour_temperature_K(sky), row.sky_K, 0.06 * row.sky_K) << row.sun_deg;
    EXPECT_NEAR(colour_temperature_K(sun + sky), row.both_K, 0.015 * row.both_K) << row.sun_deg;
  }
}

// Judd, MacAdam and Wyszecki 1964: chromaticities of daylight, of the sky among it, lie on one
// curve.
TEST(Atmosphere, HasColoursOfDaylight) {
  for (const double sun_deg : {60.0, 45.0, 30.0, 20.0, 10.0, 5.0}) {
    const Atmosphere air(sun_deg * degree, clear);
    for (const glm::dvec3& light : {sky_at(air, sun_deg, 90.0, 0.0), sky_klx(air, sun_deg)}) {
      const glm::dvec3 xyz = xyz_from_srgb(light);
      const double sum = xyz.x + xyz.y + xyz.z, x = xyz.x / sum;
      EXPECT_NEAR(xyz.y / sum, x * (2.870 - 3.000 * x) - 0.275, 0.012) << sun_deg;
    }
  }
}

// CIE S 011, type 12, the standard clear sky: luminance over that of the zenith. The table leaves
// out what is near the sun, where it smooths the aureole away, and the haze near the horizon.
TEST(Atmosphere, HasTheGradationOfTheStandardClearSky) {
  const auto standard = [](double sun_deg, double elevation_deg, double azimuth_deg) {
    const double e = elevation_deg * degree, s = sun_deg * degree, a = azimuth_deg * degree;
    const double from_sun =
        std::acos(std::sin(e) * std::sin(s) + std::cos(e) * std::cos(s) * std::cos(a));
    const auto indicatrix = [](double angle) {
      return 1.0 + 10.0 * (std::exp(-3.0 * angle) - std::exp(-1.5 * std::numbers::pi)) +
             0.45 * std::cos(angle) * std::cos(angle);
    };
    const auto gradation = [](double sine) { return 1.0 - std::exp(-0.32 / sine); };
    return indicatrix(from_sun) * gradation(std::sin(e)) /
           (indicatrix(0.5 * std::numbers::pi - s) * gradation(1.0));
  };
  for (const double sun_deg : {60.0, 45.0, 30.0, 20.0, 10.0}) {
    const Atmosphere air(sun_deg * degree, clear);
    const double zenith = luminance(sky_at(air, sun_deg, 90.0, 0.0));
    for (const double azimuth_deg : {90.0, 135.0, 180.0})
      for (const double elevation_deg : {30.0, 45.0, 60.0, 75.0}) {
        const double want = standard(sun_deg, elevation_deg, azimuth_deg);
        EXPECT_NEAR(luminance(sky_at(air, sun_deg, elevation_deg, azimuth_deg)) / zenith, want,
                    0.11 * want)
            << sun_deg << " " << azimuth_deg << " " << elevation_deg;
      }
  }
}

// Illuminance of level ground from noon to dusk (Seidelmann 1992, Explanatory supplement to the
// Astronomical Almanac, after Brown's charts), by the sun's elevation without air. By day it is
// that of hazy air, of a turbidity of 6; in the same air dusk has what they say.
TEST(Atmosphere, DimsAtDuskAsItDoes) {
  constexpr double hazy = 6.0;
  struct Row {
    double without_air_deg, lx, within;
  };
  const AirColumns columns;
  for (const Row& row : {Row{60.0, 103000.0, 0.1}, Row{30.0, 46300.0, 0.1}, Row{20.0, 27400.0, 0.1},
                         Row{10.0, 11100.0, 0.1}, Row{5.0, 4540.0, 0.1}, Row{0.0, 759.0, 0.1},
                         Row{-0.83, 455.0, 0.1}, Row{-2.0, 189.0, 0.1}, Row{-3.0, 79.1, 0.1},
                         Row{-4.0, 29.9, 0.1}, Row{-5.0, 10.4, 0.2}, Row{-6.0, 3.4, 0.4}}) {
    const double sun_deg = seen_deg(columns, row.without_air_deg);
    const Atmosphere air(sun_deg * degree, hazy);
    const double sun_lx = 1000.0 * luminance(air.sun_klx()) * std::sin(sun_deg * degree);
    EXPECT_NEAR(1000.0 * sky_illuminance_klx(air, sun_deg) + std::max(sun_lx, 0.0), row.lx,
                row.within * row.lx)
        << row.without_air_deg;
  }
  EXPECT_EQ(luminance(Atmosphere(-1.0 * degree, clear).sun_klx()), 0.0);
}

// Patat, Ugolnikov and Postylyakov 2006, UBVRI twilight sky brightness at ESO-Paranal: the zenith
// has V = 11.84 + 1.518 d - 0.057 d^2 magnitudes per square second, d degrees of the sun below -5;
// one of magnitude 0 is 108 kcd/m2.
TEST(Atmosphere, HasTheZenithOfClearTwilight) {
  const AirColumns columns;
  for (const double d : {0.0, 0.5, 1.0}) {
    const double measured_kcd_m2 = 108.0 * std::pow(10.0, -0.4 * (11.84 + d * (1.518 - d * 0.057)));
    const double sun_deg = seen_deg(columns, -5.0 - d);
    const double zenith =
        luminance(sky_at(Atmosphere(sun_deg * degree, very_clear), sun_deg, 90.0, 0.0));
    EXPECT_NEAR(zenith, measured_kcd_m2, 0.2 * measured_kcd_m2) << d;
  }
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
  EXPECT_LT(x_of(sky_at(dusk, -3.0, 90.0, 0.0)), 0.27);
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
