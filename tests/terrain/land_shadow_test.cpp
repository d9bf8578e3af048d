#include "terrain/land_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "light/daylight.h"
#include "support/elevation_raster.h"
#include "support/temporary_folder.h"
#include "terrain/ground.h"
#include "terrain/lighting.h"

namespace wold::terrain {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double square_m = 1000.0, cell_m = 20.0;

/// A square of 1 km in the middle of a model of 12 km, whose heights are by place from the
/// middle.
class LandShadowTest : public testing::Test {
 protected:
  scene::Terrain square_of(const std::function<double(double east_m, double north_m)>& height_m) {
    scene::Terrain terrain;
    terrain.elevation =
        test::write_elevation(folder_.path() / "dem.tif", {12000.0, cell_m}, height_m);
    terrain.size_m = square_m;
    terrain.samples = 101;
    terrain.relief_m = 0.0;
    return terrain;
  }
  static Surroundings land(const scene::Terrain& terrain) {
    return {terrain, make_ground(terrain, 3).heights_m, 3, 3500.0};
  }

  wold::test::TemporaryFolder folder_{"land_shadow"};
};

glm::dvec3 sun(double elevation_deg, double azimuth_deg) {
  return light::direction_of(azimuth_deg * degree, elevation_deg * degree);
}

/// Of a place so far from the square's middle, and so high above the level about it.
double seen(const LandShadow& shadow, const Surroundings& land, const glm::dvec2& from_middle_m,
            double above_m = 0.0) {
  const glm::dvec2 middle_m(0.5 * square_m);
  return shadow.sun_seen({middle_m + from_middle_m, land.height_m(middle_m) + above_m});
}

/// Along the meridian; its crest begins 2 km east of the middle and is 400 m high.
double ridge_m(double east_m, double) {
  return std::clamp(1000.0 - 2.0 * std::abs(east_m - 2300.0), 0.0, 400.0);
}

// A level place `d` before it sees the sun over it from the elevation atan(400 m / d) on.
TEST_F(LandShadowTest, ARidgeHidesTheSunBelowItsAngle) {
  const scene::Terrain terrain = square_of(ridge_m);
  const Surroundings around = land(terrain);
  for (const double east_m : {-400.0, 0.0, 300.0}) {
    const double horizon_deg = std::atan(400.0 / (2000.0 - east_m)) / degree;
    EXPECT_EQ(seen({around, sun(horizon_deg - 1.6, 90.0)}, around, {east_m, 100.0}), 0.0);
    EXPECT_EQ(seen({around, sun(horizon_deg + 1.6, 90.0)}, around, {east_m, 100.0}), 1.0);
    EXPECT_NEAR(seen({around, sun(horizon_deg, 90.0)}, around, {east_m, 100.0}), 0.5, 0.2);
  }
}

// Seen aslant the ridge is farther away, by the sine of the azimuth; the other way there is none.
TEST_F(LandShadowTest, FollowsTheSunsAzimuth) {
  const Surroundings around = land(square_of(ridge_m));
  const double aslant_deg = std::atan(400.0 * std::sin(40.0 * degree) / 2000.0) / degree;
  EXPECT_EQ(seen({around, sun(aslant_deg - 1.6, 40.0)}, around, {0.0, 0.0}), 0.0);
  EXPECT_EQ(seen({around, sun(aslant_deg + 1.6, 40.0)}, around, {0.0, 0.0}), 1.0);
  EXPECT_EQ(seen({around, sun(2.0, 270.0)}, around, {0.0, 0.0}), 1.0);
}

// What stands higher than the ray over the ridge is in the sun.
TEST_F(LandShadowTest, EndsWhereTheRayOverTheRidgeIs) {
  const Surroundings around = land(square_of(ridge_m));
  constexpr double elevation_deg = 6.0;
  const LandShadow shadow(around, sun(elevation_deg, 90.0));
  const double ray_m = 400.0 - 2000.0 * std::tan(elevation_deg * degree);
  const double penumbra_m = 2000.0 * 1.7 * degree;
  EXPECT_EQ(seen(shadow, around, {0.0, 0.0}, ray_m - penumbra_m), 0.0);
  EXPECT_NEAR(seen(shadow, around, {0.0, 0.0}, ray_m), 0.5, 0.2);
  EXPECT_EQ(seen(shadow, around, {0.0, 0.0}, ray_m + penumbra_m), 1.0);
}

// A cone's silhouette is a triangle: its shadow is as wide as its foot hides, and no wider.
TEST_F(LandShadowTest, OfAConeIsAWedge) {
  constexpr double peak_m = 600.0, foot_m = 600.0, away_m = 2500.0;
  const Surroundings around = land(square_of([](double east_m, double north_m) {
    return std::max(0.0, peak_m * (1.0 - std::hypot(east_m, north_m - away_m) / foot_m));
  }));
  const LandShadow shadow(around, sun(8.0, 0.0));
  // Beside the middle the silhouette of a cone stands at peak * (1 - |x| / foot).
  const double wide_m = foot_m * (1.0 - away_m * std::tan(8.0 * degree) / peak_m);
  EXPECT_EQ(seen(shadow, around, {0.0, 0.0}), 0.0);
  EXPECT_LT(seen(shadow, around, {wide_m - 120.0, 0.0}), 0.1);
  EXPECT_GT(seen(shadow, around, {wide_m + 120.0, 0.0}), 0.9);
  EXPECT_GT(seen(shadow, around, {-wide_m - 120.0, 0.0}), 0.9);
}

// A slope that faces the sun, and one that the sun only grazes, are no shadow's.
TEST_F(LandShadowTest, APlaneCastsNone) {
  const Surroundings around =
      land(square_of([](double east_m, double) { return 1000.0 + 0.1 * east_m; }));
  for (const double azimuth_deg : {90.0, 270.0, 0.0})
    for (const double east_m : {-480.0, 0.0, 480.0}) {
      const LandShadow shadow(around, sun(9.0, azimuth_deg));
      EXPECT_GT(seen(shadow, around, {east_m, 0.0}, 0.1 * east_m), 0.999)
          << azimuth_deg << " " << east_m;
    }
}

TEST_F(LandShadowTest, TakesTheSunAndLeavesTheSky) {
  const scene::Terrain terrain = square_of(ridge_m);
  const Heightfield ground = make_ground(terrain, 3).heights_m;
  const Surroundings around(terrain, ground, 3, 3500.0);
  const light::Daylight day({6.0, 90.0}, {3.0});
  const LandShadow shadow(around, day.sun_direction());
  const GroundGrid grid{ground.square(), 33};
  const GroundLight open = ground_light(ground, day, grid);
  const GroundLight shaded = ground_light(ground, day, grid, &shadow);
  EXPECT_GT(open.sun.at(16, 16).r, 0.05F);
  EXPECT_EQ(shaded.sun.at(16, 16), glm::vec3(0.0F));
  EXPECT_EQ(shaded.sky.values(), open.sky.values());
}

}  // namespace
}  // namespace wold::terrain
