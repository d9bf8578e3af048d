#include "ground/water_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "light/daylight.h"

namespace wold::ground {
namespace {

constexpr double size_m = 1200.0;

/// Water up to 600 m north, then a hillside that rises by 1 in 2; between eye and water a mound.
Heightfield lake_below_a_slope(double mound_m) {
  Heightfield heights_m(601, size_m);
  for (int j = 0; j < 601; ++j)
    for (int i = 0; i < 601; ++i) {
      const double north_m = heights_m.place_m(i, j).y;
      double height_m = std::max(0.0, 0.5 * (north_m - 600.0));
      if (std::abs(north_m - 90.0) < 10.0) height_m = mound_m;
      heights_m.at(i, j) = static_cast<float>(height_m);
    }
  return heights_m;
}

/// That water, as high as it says, from beyond the mound on.
terrain::Water lake() {
  GroundMap<int> number(241, size_m, -1);
  for (int j = 0; j < 241; ++j)
    for (int i = 0; i < 241; ++i)
      if (const double north_m = number.place_m(i, j).y; north_m > 110.0 && north_m < 590.0)
        number.at(i, j) = 0;
  return {{std::move(number), {0.0}}, 1};
}

struct View {
  Heightfield ground_m;
  terrain::Surroundings around;
  terrain::Water water = lake();
  glm::dvec3 eye_m{600.0, 50.0, 20.0};
  MirroredLand land;

  explicit View(double mound_m)
      : ground_m(lake_below_a_slope(mound_m)),
        around(scene::Terrain{}, ground_m, 1, 2000.0),
        land(around, ground_m, water, eye_m,
             {.middle_rad = 0.0, .half_rad = 0.5, .step_rad = 0.001}) {}
};

/// Where a ray from a place on the water meets the slope.
double north_m(double from_m, double rise) { return (300.0 - rise * from_m) / (0.5 - rise); }

TEST(MirroredLand, IsWhereARayFromTheWaterMeetsASlope) {
  const View view(0.0);
  const std::vector<double> rises = {0.02, 0.1333, 0.2};
  for (const double from_m : {200.0, 450.0}) {
    const auto places = view.land.met({600.0, from_m, 0.0}, rises);
    for (std::size_t k = 0; k < rises.size(); ++k) {
      ASSERT_TRUE(places[k]) << rises[k];
      EXPECT_NEAR(places[k]->y, north_m(from_m, rises[k]), 2.0);
      EXPECT_NEAR(places[k]->x, 600.0, 1.0);
    }
  }
}

// Land on the near shore does not stand before what water behind it mirrors.
TEST(MirroredLand, IsNotHiddenByWhatIsNearerThanTheWater) {
  const View view(8.0);
  const auto places = view.land.met({600.0, 200.0, 0.0}, {0.1333});
  ASSERT_TRUE(places[0]);
  EXPECT_NEAR(places[0]->y, north_m(200.0, 0.1333), 2.0);
}

// A river's surface falls between the ground's samples, which stand out of it here and there.
TEST(MirroredLand, IsNotHiddenByTheGroundUnderWater) {
  Heightfield ground_m = lake_below_a_slope(0.0);
  for (int j = 100; j < 280; ++j)
    for (int i = 0; i < 601; ++i) ground_m.at(i, j) = 0.4F;
  const terrain::Surroundings around(scene::Terrain{}, ground_m, 1, 2000.0);
  const MirroredLand land(around, ground_m, lake(), {600.0, 50.0, 20.0},
                          {.middle_rad = 0.0, .half_rad = 0.5, .step_rad = 0.001});
  for (double from_m = 250.0; from_m < 500.0; from_m += 0.7) {
    const auto places = land.met({600.0, from_m, 0.0}, {0.1333});
    ASSERT_TRUE(places[0]) << from_m;
    EXPECT_NEAR(places[0]->y, north_m(from_m, 0.1333), 2.0) << from_m;
  }
}

TEST(MirroredLand, IsNoneWhereARayMeetsTheSky) {
  const View view(0.0);
  EXPECT_FALSE(view.land.met({600.0, 200.0, 0.0}, {4.0})[0]);
}

const SunOnWater no_sun{{0.0, 0.0, -1.0}, [](const glm::dvec2&) { return glm::vec3(0.0F); }};

/// What water shows to the eye under a sky of radiance 1, at a place so far north of it.
WaterSurface under_an_even_sky(const View& view, double distance_m, double wind_m_s) {
  const Mirrored mirrored{view.land, [](const glm::dvec2&) { return glm::vec3(1.0F); },
                          [](const glm::dvec3&) { return glm::vec3(1.0F); }};
  const snow::WeatherMoment wind{.wind_speed_m_s = wind_m_s, .wind_heading_deg = 30.0};
  return water_surface({600.0, 50.0 + distance_m, 0.0}, view.eye_m,
                       Waves(wind, 0.0, 1, /*step_m=*/50.0), mirrored, no_sun);
}

// Where all around is as bright water shows its reflectance; wind lets one see steeper facets of
// far water, so that it mirrors less.
TEST(WaterSurfaceLook, OfAnEvenSkyIsItsReflectance) {
  const View view(0.0);
  for (const double distance_m : {20.0, 100.0, 400.0}) {
    const WaterSurface calm = under_an_even_sky(view, distance_m, 0.0);
    EXPECT_NEAR(calm.radiance.y, calm.reflectance, 1e-5);
    const double cosine = 20.0 / std::hypot(20.0, distance_m);
    if (distance_m < 200.0) {
      EXPECT_NEAR(calm.reflectance, light::water_reflectance(cosine), 0.02);
    }
  }
  EXPECT_LT(under_an_even_sky(view, 400.0, 8.0).reflectance,
            0.8 * under_an_even_sky(view, 400.0, 0.0).reflectance);
}

// A sky that is bright to the north only is mirrored towards an eye that looks north; a sunlit
// slope is, where rays meet it.
TEST(WaterSurfaceLook, MirrorsWhatLiesBeyondIt) {
  const View view(0.0);
  const Mirrored mirrored{view.land, [](const glm::dvec2&) { return glm::vec3(1.0F, 0.0F, 0.0F); },
                          [](const glm::dvec3& to) {
                            return to.y > 0.0 ? glm::vec3(0.0F, 0.0F, 1.0F) : glm::vec3(0.0F);
                          }};
  const Waves waves({}, 0.0, 1, /*step_m=*/50.0);
  const WaterSurface far = water_surface({600.0, 500.0, 0.0}, view.eye_m, waves, mirrored, no_sun);
  const WaterSurface near = water_surface({600.0, 58.0, 0.0}, view.eye_m, waves, mirrored, no_sun);
  EXPECT_GT(far.radiance.x, 0.8F * far.reflectance);
  EXPECT_GT(near.radiance.z, 0.95F * near.reflectance);
}

// What a map's steps show of waves and what they do not are the same waves: together as steep.
TEST(Waves, AreAsSteepAtEveryStep) {
  const snow::WeatherMoment wind{.wind_speed_m_s = 6.0, .wind_heading_deg = 0.0};
  const light::SlopeVariance all = light::slope_variance(6.0);
  for (const double step_m : {0.02, 0.3, 20.0}) {
    const Waves waves(wind, 0.0, 7, step_m);
    double along = 0.0, across = 0.0;
    constexpr int places = 20000;
    for (int i = 0; i < places; ++i) {
      const glm::dvec2 tilt = waves.tilt({3.7 * (i % 141), 5.3 * (i / 141)});
      along += tilt.y * tilt.y / places;
      across += tilt.x * tilt.x / places;
    }
    along += std::pow(waves.facets().deviation({0.0, 1.0}), 2);
    across += std::pow(waves.facets().deviation({1.0, 0.0}), 2);
    EXPECT_NEAR(along, all.along, 0.06 * all.along) << step_m;
    EXPECT_NEAR(across, all.across, 0.06 * all.across) << step_m;
  }
}

TEST(SkyPicture, IsReadByDirection) {
  Image sky(64, 32, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      sky.pixel(x, y)[0] = static_cast<float>(360.0 * (x + 0.5) / 64);
      sky.pixel(x, y)[1] = static_cast<float>(90.0 - 180.0 * (y + 0.5) / 32);
    }
  const glm::vec3 seen =
      sky_radiance(sky, light::direction_of(glm::radians(100.0), glm::radians(30.0)));
  EXPECT_NEAR(seen.x, 100.0, 0.1);
  EXPECT_NEAR(seen.y, 30.0, 0.1);
}

}  // namespace
}  // namespace wold::ground
