#include "ground/snowy_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/film_parts.h"
#include "support/temporary_folder.h"

namespace wold::ground {
namespace {

scene::Scene snowed_in(double water_mm) {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 65;
  scene.terrain.hill_height_m = 1.0;
  scene.weather.temperature_c = -5.0;
  scene.snow_cover.initial_mm = water_mm;
  scene.snow_cover.drifting = 0.0;
  scene.camera.eye_m = {4.0, 0.5};
  scene.camera.target_m = {4.0, 6.0};
  return scene;
}

/// Grass that keeps no light from the ground.
constexpr glm::vec3 in_the_open(1.0F);

template <class Meaning>
double mean(const GroundMap<float, Meaning>& map) {
  double sum = 0.0;
  for (const float value : map.values()) sum += double{value};
  return sum / static_cast<double>(map.values().size());
}

TEST(SnowyGround, WithoutSnowIsTheSites) {
  const scene::Scene scene = snowed_in(0.0);
  const place::Site site = test::site_of(scene);
  EXPECT_EQ(site.snow, nullptr);
  const SnowyGround ground(scene, site, 1);
  EXPECT_EQ(ground.surface().values(), site.terrain.values());
  EXPECT_EQ(ground.reflectance(in_the_open).values(), site.ground_reflectance.values());
  EXPECT_EQ(ground.growth().values(), site.growth.values());
  EXPECT_EQ(&ground.light(), &site.light);
}

// Where grass grows the ground has what comes through it, where none does all of the light.
TEST(SnowyGround, IsDarkUnderGrass) {
  const scene::Scene scene = snowed_in(0.0);
  place::Site site = test::site_of(scene);
  for (std::size_t i = 0; i < site.growth.values().size(); ++i)
    site.growth.values()[i] = i < site.growth.values().size() / 2 ? 0.0F : 1.0F;
  const SnowyGround ground(scene, site, 1);
  const ColourMap open = ground.reflectance(in_the_open);
  const ColourMap shaded = ground.reflectance({0.1F, 0.4F, 0.2F});
  const auto ratio = [&](int i, int j) { return shaded.at(i, j) / open.at(i, j); };
  const int last = open.samples() - 1;
  EXPECT_LT(glm::distance(ratio(last / 2, 0), glm::vec3(1.0F)), 1e-5F);
  EXPECT_LT(glm::distance(ratio(last / 2, last), glm::vec3(0.1F, 0.4F, 0.2F)), 1e-5F);
}

// What is white is no bare ground, and of both there is the reflectance.
TEST(SnowyGround, IsBareWhereItIsNotWhite) {
  const scene::Scene green = snowed_in(0.0), white = snowed_in(60.0);
  const place::Site bare_site = test::site_of(green), white_site = test::site_of(white);
  EXPECT_EQ(SnowyGround(green, bare_site, 1).bare().values(),
            bare_site.ground_reflectance.values());
  const SnowyGround snowy(white, white_site, 1);
  const ColourMap bare = snowy.bare();
  double left = 0.0, all = 0.0;
  for (std::size_t i = 0; i < bare.values().size(); ++i) {
    left += double{bare.values()[i].g};
    all += double{white_site.ground_reflectance.values()[i].g};
  }
  EXPECT_NEAR(left / all, 1.0 - snowy.white_fraction(), 0.02);
}

// An hour of rain leaves bare ground about half as bright, and no snow.
TEST(SnowyGround, IsDarkWhereRainHasWettedIt) {
  scene::Scene rainy = snowed_in(0.0);
  rainy.weather.temperature_c = 12.0;
  rainy.weather.precipitation_mm_h = 5.0;
  rainy.weather.earlier_h = 1.0;
  const place::Site site = test::site_of(rainy);
  const SnowyGround ground(rainy, site, 1);
  EXPECT_EQ(ground.white_fraction(), 0.0);
  const ColourMap wet = ground.reflectance(in_the_open);
  for (std::size_t i = 0; i < wet.values().size(); i += 97)
    for (int channel = 0; channel < 3; ++channel) {
      const float dry = site.ground_reflectance.values()[i][channel];
      EXPECT_GT(wet.values()[i][channel], 0.5F * dry);
      EXPECT_LT(wet.values()[i][channel], 0.7F * dry);
    }
}

// As much snow lies over the ground as the weather has left: its volume is the mean depth's.
TEST(SnowyGround, RisesByTheDepth) {
  const scene::Scene scene = snowed_in(40.0);
  const place::Site site = test::site_of(scene);
  const SnowyGround ground(scene, site, 1);
  const double depth_m = mean(site.snow->ground.at(0.0).depth_m);
  EXPECT_GT(depth_m, 0.2);
  EXPECT_NEAR(mean(ground.surface()) - mean(site.terrain), depth_m, 0.03 * depth_m);
  for (std::size_t i = 0; i < site.terrain.values().size(); ++i)
    EXPECT_GE(ground.surface().values()[i], site.terrain.values()[i]);
}

// Snow smooths what is smaller than it is deep: the surface bends less than the ground.
TEST(SnowyGround, LiesSmooth) {
  const scene::Scene scene = snowed_in(130.0);
  const place::Site site = test::site_of(scene);
  const SnowyGround ground(scene, site, 1);
  const auto bends = [](const Heightfield& map) {
    double sum = 0.0;
    for (int j = 1; j + 1 < map.samples(); ++j)
      for (int i = 1; i + 1 < map.samples(); ++i) {
        const double bend = map.at(i - 1, j) + map.at(i + 1, j) - 2.0 * map.at(i, j);
        sum += bend * bend;
      }
    return sum;
  };
  EXPECT_LT(bends(ground.surface()), 0.7 * bends(site.terrain));
}

// Deeper than the grass it is as white as fresh snow, and no grass grows out of it.
TEST(SnowyGround, DeepSnowIsAllThatIsSeen) {
  const scene::Scene scene = snowed_in(60.0);
  const place::Site site = test::site_of(scene);
  const SnowyGround ground(scene, site, 1);
  const ColourMap map = ground.reflectance(in_the_open);
  for (const glm::vec3& reflectance : map.values()) {
    EXPECT_GT(reflectance.g * std::numbers::pi_v<float>, 0.8F);
    EXPECT_LT(reflectance.g * std::numbers::pi_v<float>, 0.97F);
  }
  const FactorMap growth = ground.growth();
  EXPECT_LT(*std::max_element(growth.values().begin(), growth.values().end()), 1e-6F);
  EXPECT_NEAR(ground.mean_albedo(), 0.95, 0.02);
}

TEST(SnowyGround, ThePapersWhiteningLeavesTheShapeAndHidesTheGrass) {
  scene::Scene scene = snowed_in(6.0);
  scene.snow_cover.cover = scene::CoverModel::paper;
  const place::Site site = test::site_of(scene);
  const SnowyGround ground(scene, site, 1);
  EXPECT_EQ(ground.surface().values(), site.terrain.values());
  // 6 of white_after's 8 mm: three dots a texel, so that 1 - exp(-3) of it is white.
  EXPECT_NEAR(mean(ground.growth()), std::exp(-3.0), 0.02);
  EXPECT_NEAR(mean(ground.extinction_factor(site.growth)), std::exp(-3.0), 0.02);
  EXPECT_NEAR((ground.mean_albedo() - 0.2) / (0.95 - 0.2), 1.0 - std::exp(-3.0), 0.02);
}

/// Brightness of ledges over that of walls.
double ledges_over_walls(const ColourMap& reflectance, const FactorMap& ledges) {
  double walls = 0.0, held = 0.0;
  int of_walls = 0, of_held = 0;
  for (std::size_t k = 0; k < ledges.values().size(); ++k) {
    const double bright{reflectance.values()[k].g};
    if (ledges.values()[k] < 0.1F) walls += bright, ++of_walls;
    if (ledges.values()[k] > 0.9F) held += bright, ++of_held;
  }
  EXPECT_GT(of_walls, 20);
  EXPECT_GT(of_held, 20);
  return held / of_held * of_walls / walls;
}

// However much snow lies on a large terrain, rock shows through where it is too steep: on the map
// of the whole and on those of its parts.
TEST(SnowyGround, LeavesWallsBare) {
  const test::TemporaryFolder folder("walls");
  scene::Scene scene = snowed_in(200.0);
  scene.terrain.shape = scene::TerrainShape::mountain;
  scene.terrain.size_m = 2000.0;
  scene.terrain.samples = 129;
  scene.terrain.hill_height_m = 1500.0;
  scene.terrain.talus_deg = 80.0;
  const place::Site site = test::site_of(scene, folder.path());
  ASSERT_TRUE(site.ledges);
  const SnowyGround ground(scene, site, 1);
  EXPECT_GT(ledges_over_walls(ground.reflectance(in_the_open), *site.ledges), 3.0);
  const GroundGrid grid{{{600.0, 600.0}, 800.0}, 401};
  const place::GroundPart part = place::ground_part(scene, site, grid, {});
  ASSERT_TRUE(part.ledges);
  EXPECT_GT(ledges_over_walls(ground.covered(part, in_the_open).part.reflectance, *part.ledges),
            3.0);
  // Place by place as on the mean: deep snow has no patches.
  double white = 0.0;
  for (int j = 0; j < site.ledges->samples(); ++j)
    for (int i = 0; i < site.ledges->samples(); ++i)
      white += double{ground.white_fraction(site.ledges->place_m(i, j))};
  EXPECT_NEAR(white / static_cast<double>(site.ledges->values().size()), ground.white_fraction(),
              0.01);
  EXPECT_LT(ground.white_fraction(), 0.97);
}

TEST(SnowyGround, LiesOnBouldersButNotOnTheirSides) {
  scene::Scene scene = snowed_in(12.0);
  scene.terrain.boulders_per_hectare = 200.0;
  scene.terrain.size_m = 20.0;
  const place::Site site = test::site_of(scene);
  const SnowyGround ground(scene, site, 1);
  const terrain::Surface surface = site.surface({site.terrain.square(), 801});
  int tops = 0, sides = 0;
  double white_on_sides = 0.0;
  for (int j = 0; j < 801; ++j)
    for (int i = 0; i < 801; ++i) {
      const terrain::NearbyBoulders::Rise rise = surface.boulder(i, j);
      const glm::dvec2 at_m = surface.place_m(i, j);
      if (rise.cover < 1.0 || rise.height_m < double{ground.depth_m(at_m)} + 0.1) continue;
      const float white = ground.white_fraction(at_m);
      const double slope_deg = surface.slope_deg(i, j);
      if (slope_deg > 67.0) {
        ++sides;
        white_on_sides += double{white};
      } else if (slope_deg < 30.0) {
        tops += white > 0.5F;
      }
    }
  EXPECT_GT(tops, 200);
  ASSERT_GT(sides, 200);
  EXPECT_LT(white_on_sides / sides, 0.1);
}

// Of light on snow half a metre deep, whose surface is as level as the ground.
TEST(SnowyGround, IsUnevenInLightWhereWindHasCarvedIt) {
  const auto unevenness = [](double drifting, double water_mm) {
    scene::Scene scene = snowed_in(water_mm);
    scene.terrain.hill_height_m = 0.0;
    scene.terrain.relief_m = 0.0;
    scene.grass.height_m = 0.05;  // none stands out
    scene.snow_cover.drifting = drifting;
    const place::Site site = test::site_of(scene);
    const SnowyGround ground(scene, site, 1);
    double sum = 0.0, sum2 = 0.0;
    const auto count = static_cast<double>(ground.light().sun.values().size());
    for (const glm::vec3& sun : ground.light().sun.values()) {
      sum += double{sun.g} / count;
      sum2 += double{sun.g} * double{sun.g} / count;
    }
    return std::sqrt(std::max(sum2 / (sum * sum) - 1.0, 0.0));
  };
  const double without = unevenness(0.0, 120.0), deep = unevenness(0.5, 120.0);
  EXPECT_GT(deep, without + 0.03);
  EXPECT_GT(unevenness(1.0, 120.0), deep + 0.02);
  EXPECT_LT(unevenness(0.5, 12.0), without + 0.7 * (deep - without));
}

}  // namespace
}  // namespace wold::ground
