#include "light/daylight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "core/error.h"

namespace wold::light {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(Daylight, PointsToTheSunClockwiseFromNorth) {
  const glm::dvec3 east = Daylight({30.0, 90.0}, {3.0}).sun_direction();
  EXPECT_NEAR(east.x, std::cos(30.0 * degree), 1e-12);
  EXPECT_NEAR(east.y, 0.0, 1e-12);
  EXPECT_NEAR(east.z, 0.5, 1e-12);
  EXPECT_LT(Daylight({30.0, 180.0}, {3.0}).sun_direction().y, -0.86);
}

/// Irradiance of a horizontal plane by summing a lat-long picture's radiances.
glm::dvec3 irradiance_of(const Daylight& day) {
  glm::dvec3 sum(0.0);
  const int rows = 180;
  const int columns = 360;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double elevation = (r + 0.5) / rows * std::numbers::pi / 2.0;
      const glm::dvec3 to = direction_of(2.0 * std::numbers::pi * (c + 0.5) / columns, elevation);
      sum += glm::dvec3(day.sky_radiance(to)) * std::cos(elevation) * to.z;
    }
  return sum * (std::numbers::pi / 2.0 / rows * 2.0 * std::numbers::pi / columns);
}

TEST(Daylight, OpenFlatGroundReceivesOne) {
  for (const double elevation_deg : {8.0, 38.0, 75.0}) {
    const Daylight day({elevation_deg, 235.0}, {3.0});
    const glm::dvec3 total =
        irradiance_of(day) + glm::dvec3(day.sun_irradiance()) * day.sun_direction().z;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(total[c], 1.0, 2e-3);
      EXPECT_NEAR(day.sky_irradiance()[c] + day.sun_irradiance()[c] * day.sun_direction().z, 1.0,
                  1e-6);
    }
    EXPECT_GT(day.sun_irradiance().r, day.sun_irradiance().b);
    EXPECT_GT(day.sky_irradiance().b, day.sky_irradiance().r);
  }
}

// When the sun has set the sky is all the light there is: level ground is as luminous as by day,
// but blue. Clouds have the sun for longer.
TEST(Daylight, IsThatOfTheSkyAtDusk) {
  for (const double elevation_deg : {-0.5, -2.0, -4.0}) {
    const Daylight dusk({elevation_deg, 270.0}, {2.5});
    EXPECT_EQ(dusk.sun_irradiance(), glm::vec3(0.0F));
    EXPECT_EQ(dusk.level_irradiance(), dusk.sky_irradiance());
    EXPECT_NEAR(luminance(dusk.level_irradiance()), 1.0, 1e-6);
    EXPECT_GT(dusk.level_irradiance().b, 1.2F * dusk.level_irradiance().r);
    const glm::dvec3 level = irradiance_of(dusk);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(level[c] / dusk.level_irradiance()[c], 1.0, 2e-3);
    for (const float value : dusk.sky_image(64).values) {
      ASSERT_TRUE(std::isfinite(value));
      ASSERT_GE(value, 0.0F);
    }
  }
  EXPECT_GT(Daylight({-1.0, 270.0}, {2.5}).sun_irradiance_at(3000.0).r, 0.1F);
  EXPECT_EQ(Daylight({-3.0, 270.0}, {2.5}).sun_irradiance_at(3000.0).r, 0.0F);
}

// Most of the aerosol lies below clouds: a low sun shines on them as it does not on the ground, and
// less red.
TEST(Daylight, IsBrighterInTheHeightWhenTheSunIsLow) {
  const Daylight high({60.0, 235.0}, {2.5}), low({3.0, 235.0}, {2.5});
  EXPECT_EQ(low.sun_irradiance_at(0.0), low.sun_irradiance());
  EXPECT_GT(low.sun_irradiance_at(1500.0).g, 3.0F * low.sun_irradiance().g);
  EXPECT_GT(low.sun_irradiance_at(8000.0).b / low.sun_irradiance_at(8000.0).r,
            2.0F * low.sun_irradiance_at(1500.0).b / low.sun_irradiance_at(1500.0).r);
  EXPECT_LT(high.sun_irradiance_at(8000.0).g, 1.4F * high.sun_irradiance().g);
}

TEST(Daylight, MeanOverAzimuthGivesTheSkysIrradiance) {
  const Daylight day({38.0, 235.0}, {3.0});
  glm::dvec3 sum(0.0);
  const int rows = 500;
  for (int r = 0; r < rows; ++r) {
    const double elevation = (r + 0.5) / rows * std::numbers::pi / 2.0;
    sum += glm::dvec3(day.mean_sky_radiance(elevation)) *
           (std::numbers::pi * std::sin(2.0 * elevation) * std::numbers::pi / 2.0 / rows);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], day.sky_irradiance()[c], 1e-3);
}

TEST(Daylight, PictureShowsTheSkyWithoutFireflies) {
  const Daylight day({38.0, 235.0}, {3.0});
  const Image sky = day.sky_image(720);
  ASSERT_EQ(sky.height, 360);
  const float* north_east = sky.pixel(90, 120);  // azimuth 45.25, elevation 29.75 degrees
  const glm::vec3 want = day.sky_radiance(direction_of(45.25 * degree, 29.75 * degree));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(north_east[c], want[c], 1e-5);
  float brightest = 0.0F;
  std::size_t at = 0;
  for (std::size_t k = 0; k < sky.values.size(); ++k) {
    EXPECT_GE(sky.values[k], 0.0F);
    if (sky.values[k] > brightest) brightest = sky.values[at = k];
  }
  EXPECT_LT(brightest, 20.0F);
  const std::size_t pixel = at / 3;
  EXPECT_NEAR(static_cast<double>(pixel % 720) * 0.5, 235.0, 1.0);
  EXPECT_NEAR(90.0 - static_cast<double>(pixel / 720) * 0.5, 38.0, 1.0);
}

// The plain vanishes in the haze at the horizon: radiance goes on across it, bright below the sun
// and dark away from it. Haze close by has the light of all directions, whichever way one looks.
TEST(Daylight, GoesOnAcrossTheHorizon) {
  const Daylight day({10.0, 90.0}, {3.0});
  for (const double azimuth_deg : {90.0, 150.0, 270.0}) {
    const auto at = [&](double elevation_deg) {
      return day.sky_radiance(direction_of(azimuth_deg * degree, elevation_deg * degree));
    };
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(at(-1e-3)[c], at(0.0)[c], 1e-3F * at(0.0)[c]);
  }
  const auto near_haze = [&](double azimuth_deg) {
    return day.haze_radiance(direction_of(azimuth_deg * degree, -1.0 * degree), 0.0);
  };
  EXPECT_EQ(near_haze(90.0), near_haze(270.0));
}

TEST(Daylight, RefusesWhatTheModelCannotDo) {
  EXPECT_NO_THROW(Daylight({-10.0, 0.0}, {3.0}));
  EXPECT_THROW(Daylight({-10.5, 0.0}, {3.0}), InputError);
  EXPECT_THROW(Daylight({30.0, 0.0}, {1.0}), InputError);
}

}  // namespace
}  // namespace wold::light
