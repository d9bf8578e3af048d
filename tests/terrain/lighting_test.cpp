#include "terrain/lighting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "terrain/hillside.h"
#include "terrain/horizon.h"
#include "terrain/mountain.h"
#include "terrain/surface.h"

namespace wold::terrain {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

/// Ground whose height depends on y alone.
template <class Height>
Heightfield ground(double size_m, int samples, const Height& height_m) {
  Heightfield terrain(samples, size_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      terrain.at(i, j) = static_cast<float>(height_m(j * terrain.step_m()));
  return terrain;
}

glm::vec3 middle(const ColourMap& map) { return map.sample(map.size_m() / 2, map.size_m() / 2); }

TEST(LightMap, FlatGroundIsOne) {
  const light::Daylight day({38.0, 235.0}, {3.0});
  const ColourMap light =
      ground_light(ground(20.0, 41, [](double) { return 0.0; }), day).together();
  for (const glm::vec3& value : light.values())
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], 1.0F, 1e-4F);
}

// Light of a wide terrain is sampled as finely as its heights say anything: all else costs minutes.
TEST(LightMap, IsNoFinerThanHalfOfTheTerrainsStep) {
  const light::Daylight day({38.0, 235.0}, {3.0});
  const auto samples = [&](double size_m) {
    return ground_light(ground(size_m, 41, [](double) { return 0.0; }), day).sun.samples();
  };
  EXPECT_EQ(samples(8.0), 41);  // 20 cm
  EXPECT_EQ(samples(80.0), 81);
}

// What does not count is dark; what does, but for its border, is as if all did.
TEST(LightMap, IsMadeWhereItCounts) {
  const light::Daylight day({38.0, 235.0}, {3.0});
  const Heightfield terrain = ground(80.0, 81, [](double y) { return 6.0 * std::sin(0.2 * y); });
  const GroundGrid grid{terrain.square(), 41};
  RowParts parts(41);
  for (std::size_t j = 10; j < 30; ++j) parts[j] = {{4, 12}, {20, 41}};
  const GroundLight whole = ground_light(terrain, day, grid);
  const GroundLight part = ground_light(terrain, day, grid, nullptr, parts);
  EXPECT_EQ(part.sky.at(16, 20), glm::vec3(0.0F));
  EXPECT_EQ(part.sun.at(30, 5), glm::vec3(0.0F));
  for (int j = 11; j < 29; ++j)
    for (const int i : {5, 8, 10, 21, 30, 40}) {
      EXPECT_EQ(part.sun.at(i, j), whole.sun.at(i, j));
      EXPECT_EQ(part.sky.at(i, j), whole.sky.at(i, j));
      EXPECT_EQ(part.overcast.at(i, j), whole.overcast.at(i, j));
    }
}

TEST(LightMap, InclinedPlaneReceivesTheIntegralOverItsHemisphere) {
  const light::Daylight day({38.0, 180.0}, {3.0});
  const double tilt = 20.0 * degree;  // rises northwards, so it faces the sun in the south
  const ColourMap light =
      ground_light(ground(40.0, 81, [&](double y) { return std::tan(tilt) * y; }), day).together();
  const glm::dvec3 up(0.0, -std::sin(tilt), std::cos(tilt));
  glm::dvec3 want = glm::dvec3(day.sun_irradiance()) * std::cos((90.0 - 38.0 - 20.0) * degree);
  for (double elevation = 0.5; elevation < 90.0; elevation += 1.0)
    for (double azimuth = 0.5; azimuth < 360.0; azimuth += 1.0) {
      const glm::dvec3 to = light::direction_of(azimuth * degree, elevation * degree);
      want += glm::dvec3(day.sky_radiance(to)) * std::max(0.0, glm::dot(up, to)) *
              (std::cos(elevation * degree) * degree * degree);
    }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(middle(light)[c], want[c], 0.01 * want[c]);
}

TEST(LightMap, OvercastSkyLightsAnInclinedPlaneAlikeOnAllSides) {
  const light::Daylight day({38.0, 180.0}, {3.0});
  const double tilt = 30.0 * degree;
  const auto overcast = [&](double rise) {
    const FactorMap map =
        ground_light(ground(40.0, 81, [&](double y) { return rise * y; }), day).overcast;
    return double{map.sample(20.0, 20.0)};
  };
  const glm::dvec3 up(0.0, -std::sin(tilt), std::cos(tilt));
  double want = 0.0;
  for (double elevation = 0.5; elevation < 90.0; elevation += 1.0)
    for (double azimuth = 0.5; azimuth < 360.0; azimuth += 1.0) {
      const glm::dvec3 to = light::direction_of(azimuth * degree, elevation * degree);
      want += (1.0 + 2.0 * to.z) * std::max(0.0, glm::dot(up, to)) *
              (std::cos(elevation * degree) * degree * degree);
    }
  want /= 7.0 * pi / 3.0;  // of level ground
  EXPECT_NEAR(overcast(0.0), 1.0, 1e-4);
  EXPECT_NEAR(overcast(std::tan(tilt)), want, 0.01 * want);
  EXPECT_NEAR(overcast(-std::tan(tilt)), want, 0.01 * want);
}

TEST(Horizon, OfAWallIsItsAngle) {
  // 2 m high, 5 m north of the point.
  const Heightfield wall = ground(20.0, 201, [](double y) { return y > 14.95 ? 2.0 : 0.0; });
  const Horizons horizons(wall, {{0.0, 1.0}, {0.0, -1.0}, {std::sin(1.0), std::cos(1.0)}}, 0.02);
  const glm::dvec2 from_m(10.0, 10.0);
  EXPECT_NEAR(horizons.elevation_rad(0, from_m, -1.0), std::atan(2.0 / 5.0), 0.02);
  EXPECT_NEAR(horizons.elevation_rad(1, from_m, -1.0), 0.0, 1e-6);
  EXPECT_NEAR(horizons.elevation_rad(2, from_m, -1.0), std::atan(2.0 * std::cos(1.0) / 5.0), 0.02);
}

std::vector<glm::dvec2> directions_all_around() {
  std::vector<glm::dvec2> directions;
  for (int k = 0; k < 63; ++k) directions.emplace_back(std::sin(0.1 * k), std::cos(0.1 * k));
  return directions;
}

/// Against all ground points on the way.
void expect_horizon_of_all_ground(const Horizons& horizons, const Heightfield& terrain,
                                  std::size_t k, const glm::dvec2& from_m) {
  const double height_m = terrain.sample(from_m.x, from_m.y);
  double steepest = -1.0;
  for (double way_m = terrain.step_m();; way_m += std::max(terrain.step_m(), 0.01 * way_m)) {
    const glm::dvec2 at_m = from_m + directions_all_around()[k] * way_m;
    if (!terrain.square().contains(at_m)) break;
    steepest = std::max(steepest, (terrain.sample(at_m.x, at_m.y) - height_m) / way_m);
  }
  EXPECT_NEAR(horizons.elevation_rad(k, from_m, -1.0), std::atan(steepest), 1e-6);
  EXPECT_NEAR(horizons.elevation_rad(k, from_m, 0.1), std::atan(std::max(steepest, 0.1)), 1e-6);
}

// What it knows of the ground ahead ends its search early, and never too early.
TEST(Horizon, IsThatOfAllGroundOfAMountain) {
  scene::Terrain shape;
  shape.size_m = 300.0;
  shape.hill_height_m = 90.0;
  shape.samples = 193;
  const Heightfield terrain = make_mountain(shape, 4);
  const Horizons horizons(terrain, directions_all_around(), 0.01);
  for (std::uint64_t i = 0; i < 4000; ++i)
    expect_horizon_of_all_ground(horizons, terrain, i % horizons.directions(),
                                 300.0 * glm::dvec2(random_uniform({1, key_of("east"), i, 0}),
                                                    random_uniform({1, key_of("north"), i, 0})));
}

TEST(Horizon, IsThatOfASpikeOnThePlain) {
  Heightfield plain(321, 320.0);
  plain.at(173, 153) = 60.0F;
  const Horizons horizons(plain, directions_all_around(), 0.01);
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const std::size_t k = i % horizons.directions();
    const double way_m = 150.0 * random_uniform({1, key_of("way"), i, 0});
    expect_horizon_of_all_ground(horizons, plain, k,
                                 glm::dvec2(173.0, 153.0) - directions_all_around()[k] * way_m);
  }
}

TEST(LightMap, WallCastsAShadowOfItsLength) {
  // Sun in the north at 30 degrees: a 2 m wall at y = 15 m shades down to y = 15 - 2 / tan 30.
  const light::Daylight day({30.0, 0.0}, {3.0});
  const ColourMap light =
      ground_light(ground(20.0, 201, [](double y) { return y > 14.95 ? 2.0 : 0.0; }), day)
          .together();
  const double edge_m = 15.0 - 2.0 / std::tan(30.0 * degree);
  const auto red = [&](double y_m) { return light.sample(10.0, y_m).r; };
  EXPECT_LT(red(edge_m + 1.0), day.sky_irradiance().r * 1.05F);
  EXPECT_GT(red(edge_m - 1.0), 0.9F);
  // Half of the sun is left at the edge.
  const float lit = red(edge_m - 1.0);
  const float dark = red(edge_m + 1.0);
  double crossing_m = edge_m - 1.0;
  while (red(crossing_m) > 0.5F * (lit + dark)) crossing_m += 0.01;
  EXPECT_NEAR(crossing_m, edge_m, 0.15);
}

TEST(LightMap, HasNoSteps) {
  scene::Terrain shape;
  shape.size_m = 20.0;
  shape.samples = 161;
  const Heightfield terrain = make_hillside(shape, 4);
  const ColourMap light = ground_light(terrain, light::Daylight({15.0, 235.0}, {3.0})).together();
  double largest = 0.0;
  for (int j = 1; j + 1 < light.samples(); ++j)
    for (int i = 1; i + 1 < light.samples(); ++i)
      largest = std::max<double>(
          largest, std::abs(light.at(i + 1, j).g - 2.0F * light.at(i, j).g + light.at(i - 1, j).g));
  EXPECT_LT(largest, 0.25);  // a hard edge of the sun's shadow has 1.2
}

const GroundGrid every_3_cm{{.size_m = 20.0}, map_samples(20.0, 0.03)};

TEST(GroundReflectance, IsLambertsOnAverage) {
  const scene::Terrain shape;
  const Heightfield level = ground(20.0, 51, [](double) { return 0.0; });
  const ColourMap reflectance = ground_reflectance(
      Surface(level, nullptr, every_3_cm), {0.0, 0.6, 0.8}, shape, 9, FactorMap(2, 20.0, 1.0F));
  glm::dvec3 mean(0.0);
  for (const glm::vec3& value : reflectance.values()) {
    EXPECT_GT(value.r, 0.0F);
    mean += glm::dvec3(value) / static_cast<double>(reflectance.values().size());
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const double want = shape.ground_albedo[c] / pi;
    EXPECT_NEAR(mean[static_cast<glm::length_t>(c)], want, 0.08 * want);
  }
}

// Rock is bare: where grass grows on a steep slope, it stands on soil.
TEST(GroundReflectance, GrassStandsOnSoil) {
  scene::Terrain shape;
  shape.rock_albedo = {0.0, 0.0, 0.9};
  const Heightfield steep = ground(20.0, 51, [](double y) { return 2.0 * y; });
  const auto blue_over_red = [&](float growth) {
    const glm::vec3 at =
        middle(ground_reflectance(Surface(steep, nullptr, every_3_cm), {0.0, 0.6, 0.8}, shape, 9,
                                  FactorMap(2, 20.0, growth)));
    return at.b / std::max(at.r, 1e-6F);
  };
  EXPECT_LT(blue_over_red(1.0F), 1.0F);
  EXPECT_GT(blue_over_red(0.0F), 100.0F);
}

}  // namespace
}  // namespace wold::terrain
