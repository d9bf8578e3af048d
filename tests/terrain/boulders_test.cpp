#include "terrain/boulders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "core/random.h"
#include "terrain/lighting.h"
#include "terrain/surface.h"

namespace wold::terrain {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Boulder boulder_of(std::uint64_t number, double width_m = 1.6) {
  return {glm::dvec2(3.0, 5.0), width_m, mixed(number)};
}

glm::dvec2 heading(double turn) {
  return {std::cos(2.0 * std::numbers::pi * turn), std::sin(2.0 * std::numbers::pi * turn)};
}

TEST(Boulder, IsConvex) {
  for (std::uint64_t number = 0; number < 50; ++number) {
    const Boulder boulder = boulder_of(number);
    for (std::uint64_t k = 0; k < 100; ++k) {
      const auto place = [&](std::uint64_t which) {
        return boulder.middle_m() +
               0.5 * random_uniform({number, k, which, 0}) * heading(random_uniform({7, k, which}));
      };
      const glm::dvec2 a = place(0), b = place(1);
      EXPECT_GE(boulder.top(0.5 * (a + b)).height_m,
                0.5 * (boulder.top(a).height_m + boulder.top(b).height_m) - 1e-9);
    }
  }
}

TEST(Boulder, HasTheGradientOfItsHeights) {
  constexpr double step_m = 1e-5;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const Boulder boulder = boulder_of(number);
    const glm::dvec2 at_m = boulder.middle_m() + 0.5 * random_uniform({number, 1}) *
                                                     heading(random_uniform({number, 2}));
    const auto rise = [&](const glm::dvec2& way) {
      return (boulder.top(at_m + step_m * way).height_m -
              boulder.top(at_m - step_m * way).height_m) /
             (2.0 * step_m);
    };
    const glm::dvec2 gradient = boulder.top(at_m).gradient;
    EXPECT_NEAR(gradient.x, rise({1, 0}), 1e-4) << number;
    EXPECT_NEAR(gradient.y, rise({0, 1}), 1e-4) << number;
  }
}

// About as wide as it is said to be, a quarter to two thirds as high, and nowhere beyond its reach.
TEST(Boulder, IsAsLargeAsItIsSaid) {
  double widths = 0.0, heights = 0.0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    const Boulder boulder = boulder_of(number, 2.0);
    double widest_m = 0.0;
    for (int way = 0; way < 32; ++way) {
      const double rim_m = boulder.rim_m(heading(way / 64.0)),
                   other_m = boulder.rim_m(-heading(way / 64.0));
      widest_m = std::max(widest_m, rim_m + other_m);
      EXPECT_NEAR(boulder.top(boulder.middle_m() + rim_m * heading(way / 64.0)).height_m, 0.0,
                  0.01);
      EXPECT_LT(rim_m, 0.995 * Boulder::reach_m(2.0)) << number;
    }
    widths += widest_m / 300.0;
    const double height_m = boulder.top(boulder.middle_m()).height_m;
    heights += height_m / 300.0;
    EXPECT_GT(height_m, 0.25 * 2.0 * 0.5) << number;
    EXPECT_LT(height_m, 0.7 * 2.0) << number;
    for (std::uint64_t k = 0; k < 50; ++k)
      EXPECT_LT(boulder
                    .top(boulder.middle_m() +
                         random_uniform({number, k, 3}) * heading(random_uniform({number, k, 4})))
                    .height_m,
                Boulder::most_height_m(2.0));
  }
  EXPECT_NEAR(widths, 2.0, 0.2);
  EXPECT_NEAR(heights / 2.0, 0.34, 0.08);
}

// The middle of its shadow lies away from the sun; the tip of it where the sun's rays over its top
// meet the ground, sooner where that rises.
TEST(Boulder, CastsAShadowAwayFromTheSun) {
  for (const double sun_deg : {12.0, 30.0, 50.0})
    for (const double ground_deg : {-5.0, 0.0, 8.0}) {
      const glm::dvec3 to_sun(-std::cos(sun_deg * degree), 0.0, std::sin(sun_deg * degree));
      const glm::dvec2 ascent(std::tan(ground_deg * degree), 0.0);
      double shadow_m = 0.0, height_m = 0.0;
      for (std::uint64_t number = 0; number < 60; ++number) {
        const Boulder boulder = boulder_of(number);
        height_m += boulder.top(boulder.middle_m()).height_m;
        for (double far_m = 0.0; far_m < 30.0; far_m += 0.01) {
          const glm::dvec2 at_m = boulder.middle_m() + glm::dvec2(far_m, 0.0);
          if (boulder.light_beside(at_m, to_sun, ascent).sun < 0.5) shadow_m += 0.01;
          EXPECT_EQ(
              boulder
                  .light_beside(boulder.middle_m() - glm::dvec2(far_m + 1.3, 0.0), to_sun, ascent)
                  .sun,
              1.0);
        }
      }
      // An ellipsoid's shadow is longer than that of its top: by its width where the sun is high.
      const double of_top_m =
          height_m / (std::tan(sun_deg * degree) + std::tan(ground_deg * degree));
      EXPECT_GT(shadow_m, 0.8 * of_top_m) << sun_deg << " on " << ground_deg;
      EXPECT_LT(shadow_m, 1.1 * of_top_m + 60 * 0.8) << sun_deg << " on " << ground_deg;
    }
}

constexpr double size_m = 1000.0;

Heightfield slope(double slope_deg, int samples = 101) {
  Heightfield heights_m(samples, size_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      heights_m.at(i, j) =
          static_cast<float>(std::tan(slope_deg * degree) * heights_m.place_m(i, j).y);
  return heights_m;
}

scene::Terrain terrain_with(double boulders_per_hectare) {
  scene::Terrain terrain;
  terrain.size_m = size_m;
  terrain.boulders_per_hectare = boulders_per_hectare;
  return terrain;
}

Boulders boulders_on(const Heightfield& heights_m, double per_hectare, const Scree* scree = nullptr,
                     std::shared_ptr<const Water> water = nullptr) {
  return {heights_m, terrain_with(per_hectare), 5, scree, std::move(water)};
}

std::size_t count_wider(const Boulders& boulders, double width_m) {
  const NearbyBoulders nearby = boulders.nearby({.size_m = size_m}, 0.0);
  return static_cast<std::size_t>(std::ranges::count_if(
      nearby.all(), [&](const Boulder& boulder) { return boulder.width_m() >= width_m; }));
}

TEST(Boulders, AreAsManyOnAHectareAsTheSceneSays) {
  const Heightfield plane = slope(4.0);
  for (const double per_hectare : {5.0, 40.0, 100.0, 200.0})
    EXPECT_NEAR(static_cast<double>(count_wider(boulders_on(plane, per_hectare), 1.0)),
                100.0 * per_hectare, 9.0 * per_hectare)
        << per_hectare;
}

TEST(Boulders, AreFewerTheWiderByTheInverseSquare) {
  const Boulders boulders = boulders_on(slope(4.0), 60.0);
  const auto wider_than_1 = static_cast<double>(count_wider(boulders, 1.0));
  for (const double width_m : {0.5, 0.7, 1.4, 2.5})
    EXPECT_NEAR(static_cast<double>(count_wider(boulders, width_m)),
                wider_than_1 * (1.0 / (width_m * width_m) - 1.0 / (4.63 * 4.63)) /
                    (1.0 - 1.0 / (4.63 * 4.63)),
                0.08 * wider_than_1 / (width_m * width_m))
        << width_m;
  EXPECT_EQ(count_wider(boulders, 4.63), 0U);
}

TEST(Boulders, DoNotLieWhereTheyWouldRollOn) {
  EXPECT_EQ(count_wider(boulders_on(slope(42.0), 60.0), 0.0), 0U);
  EXPECT_LT(count_wider(boulders_on(slope(36.0), 60.0), 1.0),
            count_wider(boulders_on(slope(20.0), 60.0), 1.0) / 2);
}

TEST(Boulders, AreManyBelowRock) {
  // A face of 60 degrees in the north half, gentle ground in the south.
  Heightfield heights_m(201, size_m);
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 201; ++i) {
      const double north_m = heights_m.place_m(i, j).y - 500.0;
      heights_m.at(i, j) =
          static_cast<float>(north_m * std::tan((north_m > 0.0 ? 60.0 : 15.0) * degree));
    }
  const Scree scree(heights_m, 40.0, 3);
  const NearbyBoulders nearby = boulders_on(heights_m, 2.0, &scree).nearby({.size_m = size_m}, 0.0);
  const auto between = [&](double low_m, double high_m) {
    return std::ranges::count_if(nearby.all(), [&](const Boulder& boulder) {
      return low_m <= boulder.middle_m().y && boulder.middle_m().y < high_m;
    });
  };
  EXPECT_GT(between(470.0, 500.0), 5 * between(100.0, 130.0));
  EXPECT_EQ(between(520.0, 1000.0), 0);
}

TEST(Boulders, KeepOutOfWater) {
  const Heightfield plane = slope(0.0);
  Lakes lakes{GroundMap<int>(101, size_m, -1), {0.0}};
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 51; ++i) lakes.number.at(i, j) = 0;
  const auto water = std::make_shared<const Water>(lakes, 3);
  const NearbyBoulders nearby =
      boulders_on(plane, 60.0, nullptr, water).nearby({.size_m = size_m}, 0.0);
  EXPECT_FALSE(nearby.all().empty());
  for (const Boulder& boulder : nearby.all())
    EXPECT_LT(water->share(boulder.middle_m(), boulder.width_m()), 0.011);
}

TEST(Boulders, AreTheSameInWhateverSquareTheyAreAskedFor) {
  const Heightfield plane = slope(4.0);
  const Boulders boulders = boulders_on(plane, 80.0);
  const NearbyBoulders all = boulders.nearby({.size_m = size_m}, 0.05);
  const NearbyBoulders some = boulders.nearby({{400.0, 300.0}, 20.0}, 0.05);
  for (int j = 0; j <= 200; ++j)
    for (int i = 0; i <= 200; ++i) {
      const glm::dvec2 at_m = glm::dvec2(400.0, 300.0) + 0.1 * glm::dvec2(i, j);
      const glm::dvec3 to_sun = glm::normalize(glm::dvec3(0.9, -0.3, 0.2));
      ASSERT_EQ(all.at(at_m).height_m, some.at(at_m).height_m);
      ASSERT_EQ(all.light_beside(at_m, to_sun, {}).sun, some.light_beside(at_m, to_sun, {}).sun);
    }
}

// No seam where cells meet: at steps of a millimetre heights change by as much as faces rise.
TEST(Boulders, AreWholeAcrossCells) {
  const NearbyBoulders nearby = boulders_on(slope(4.0), 150.0).nearby({{100.0, 100.0}, 100.0}, 0.0);
  int on_boulders = 0;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 100000; ++i) {
      const glm::dvec2 at_m(100.0 + 1e-3 * i, 100.0 + 2.5 * j);
      const double height_m = nearby.at(at_m).height_m;
      on_boulders += height_m > 0.0;
      ASSERT_LT(std::abs(height_m - nearby.at(at_m + glm::dvec2(1e-3, 0.0)).height_m), 0.016)
          << at_m.x << ' ' << at_m.y;
    }
  EXPECT_GT(on_boulders, 40000);
}

// No seam in their shadows, either: by a millimetre light changes a little.
TEST(Boulders, ShadeAcrossCells) {
  const NearbyBoulders nearby = boulders_on(slope(4.0), 150.0).nearby({{100.0, 100.0}, 100.0}, 0.0);
  for (const double sun_deg : {6.0, 30.0}) {
    const glm::dvec3 to_sun(0.6 * std::cos(sun_deg * degree), -0.8 * std::cos(sun_deg * degree),
                            std::sin(sun_deg * degree));
    int shaded = 0;
    for (int j = 0; j < 10; ++j) {
      double before = 1.0;
      bool beside_before = false;
      for (int i = 0; i < 20000; ++i) {
        const glm::dvec2 at_m(110.0 + 1e-3 * i, 120.0 + 1.7 * j);
        const bool beside = nearby.at(at_m).height_m <= 0.0;
        const double sun = nearby.light_beside(at_m, to_sun, glm::dvec2(0.0)).sun;
        if (beside && beside_before) {
          ASSERT_LT(std::abs(sun - before), 0.05) << at_m.x << ' ' << at_m.y;
        }
        shaded += sun < 0.5;
        before = sun;
        beside_before = beside;
      }
    }
    EXPECT_GT(shaded, 1000) << sun_deg;
  }
}

// What a coarse map does not show counts as a share of its ground.
TEST(Boulders, CoverAsMuchHoweverCoarseTheMap) {
  const Heightfield plane = slope(4.0);
  const Boulders boulders = boulders_on(plane, 100.0);
  const KnownGround known{.boulders = &boulders};
  const auto mean_cover = [&](double step_m) {
    const int samples = static_cast<int>(600.0 / step_m) + 1;
    const Surface surface(plane, nullptr, {{{200.0, 200.0}, 600.0}, samples}, known);
    double sum = 0.0;
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) sum += surface.boulder(i, j).cover;
    return sum / samples / samples;
  };
  const double fine = mean_cover(0.2);
  EXPECT_GT(fine, 0.02);
  for (const double step_m : {0.8, 2.0, 4.0, 10.0})
    EXPECT_NEAR(mean_cover(step_m), fine, 0.15 * fine) << step_m;
}

TEST(Boulders, AreBuriedBySnow) {
  const Heightfield plane = slope(4.0);
  const Boulders boulders = boulders_on(plane, 100.0);
  const KnownGround known{.boulders = &boulders};
  const GroundGrid grid{{{200.0, 200.0}, 50.0}, 501};
  const auto cover_under = [&](double snow_m) {
    const Surface surface(plane, nullptr, grid, known, {},
                          {[snow_m](const glm::dvec2&) { return snow_m; }, {}});
    double sum = 0.0;
    for (int j = 0; j < grid.samples; ++j)
      for (int i = 0; i < grid.samples; ++i) {
        const NearbyBoulders::Rise rise = surface.boulder(i, j);
        sum += rise.cover;
        if (rise.cover == 0.0) {
          EXPECT_NEAR(surface.up(i, j).z, std::cos(4.0 * degree), 1e-6);
        }
      }
    return sum;
  };
  EXPECT_GT(cover_under(0.0), 1.5 * cover_under(0.3));
  EXPECT_GT(cover_under(0.3), 0.0);
  EXPECT_EQ(cover_under(3.5), 0.0);
  const Surface deep(plane, nullptr, grid, known, {}, {[](const glm::dvec2&) { return 3.5; }, {}});
  const ColourMap one(2, grid.square, glm::vec3(1.0F));
  const GroundLight light =
      deep.lit({one, one, FactorMap(2, grid.square, 1.0F)}, glm::normalize(glm::dvec3(1, 0, 0.3)));
  for (const glm::vec3& sun : light.sun.values()) ASSERT_NEAR(sun.g, 1.0F, 1e-4F);
}

// Faces that look at a low sun are brighter than the ground, and what lies behind boulders is dark.
TEST(Boulders, AreLitAndShadeTheGround) {
  const Heightfield plane = slope(0.0);
  const Boulders boulders = boulders_on(plane, 100.0);
  const KnownGround known{.boulders = &boulders};
  const GroundGrid grid{{{200.0, 200.0}, 50.0}, 1001};
  const Surface surface(plane, nullptr, grid, known);
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-1.0, 0.0, 0.4));
  const GroundLight light =
      surface.lit({ColourMap(2, grid.square, glm::vec3(1.0F)),
                   ColourMap(2, grid.square, glm::vec3(1.0F)), FactorMap(2, grid.square, 1.0F)},
                  to_sun);
  int bright = 0, dark = 0;
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i) {
      const double sun{light.sun.at(i, j).g};
      const double cosine = std::max(0.0, glm::dot(surface.up(i, j), to_sun));
      if (surface.boulder(i, j).height_m > 0.0) {
        EXPECT_LE(sun, cosine / to_sun.z + 1e-4);
        bright += sun > 1.5;
      } else {
        EXPECT_LE(sun, 1.0 + 1e-4);
        dark += sun < 0.1;
      }
      EXPECT_LE(light.sky.at(i, j).g, 1.0F + 1e-5F);
    }
  EXPECT_GT(bright, 1000);
  EXPECT_GT(dark, 5000);
}

// Under snow they shade less, and nothing where it covers them.
TEST(Boulders, ShadeLessUnderSnow) {
  const Heightfield plane = slope(0.0);
  const NearbyBoulders nearby = boulders_on(plane, 100.0).nearby({{200.0, 200.0}, 50.0}, 0.05);
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-1.0, 0.0, 0.4));
  const auto hidden = [&](double snow_m) {
    glm::dvec2 sum(0.0);
    for (int j = 0; j <= 250; ++j)
      for (int i = 0; i <= 250; ++i) {
        const Boulder::Light left = nearby.light_beside(glm::dvec2(200.0) + 0.2 * glm::dvec2(i, j),
                                                        to_sun, glm::dvec2(0.0), snow_m);
        sum += 1.0 - glm::dvec2(left.sun, left.sky);
      }
    return sum;
  };
  const glm::dvec2 bare = hidden(0.0), some = hidden(0.4), deep = hidden(3.5);
  for (int k = 0; k < 2; ++k) {
    EXPECT_LT(some[k], 0.7 * bare[k]);
    EXPECT_GT(some[k], 0.0);
    EXPECT_EQ(deep[k], 0.0);
  }
}

// About a place they are those that lie there, and no others are made.
TEST(Boulders, AboutAPlaceAreThoseThatAreWanted) {
  const Heightfield plane = slope(4.0);
  const Boulders boulders = boulders_on(plane, 80.0);
  const glm::dvec2 at_m(480.0, 530.0);
  const auto few =
      boulders.about(at_m, 20.0, [](const glm::dvec2&, double width_m) { return width_m > 1.5; });
  const NearbyBoulders nearby = boulders.nearby({.size_m = size_m}, 0.0);
  const auto wanted = [&](const Boulder& boulder) {
    const glm::dvec2 away_m = glm::abs(boulder.middle_m() - at_m);
    const double far_m = 20.0 * (boulder.width_m() < 2.15 ? 2.15 : 4.6225) - 12.0;
    return boulder.width_m() > 1.5 && std::max(away_m.x, away_m.y) < far_m;
  };
  const auto least = std::ranges::count_if(nearby.all(), wanted);
  EXPECT_GT(least, 20);
  EXPECT_EQ(std::ranges::count_if(few, wanted), least);
  for (const Boulder& boulder : few) EXPECT_GT(boulder.width_m(), 1.5);
  EXPECT_TRUE(boulders.about({-5000.0, 500.0}, 20.0, [](auto, double) { return true; }).size() <
              3000);
}

// Green rock on red soil.
TEST(Boulders, HaveTheColourOfRock) {
  const Heightfield plane = slope(0.0);
  const Boulders boulders = boulders_on(plane, 100.0);
  const KnownGround known{.boulders = &boulders};
  const GroundGrid grid{{{200.0, 200.0}, 30.0}, 301};
  const Surface surface(plane, nullptr, grid, known);
  scene::Terrain look = terrain_with(100.0);
  look.ground_albedo = {0.3, 0.0, 0.0};
  look.rock_albedo = {0.0, 0.3, 0.0};
  const ColourMap reflectance =
      ground_reflectance(surface, {0.0, 0.6, 0.8}, look, 5, FactorMap(2, grid.square, 0.0F));
  glm::dvec3 sum(0.0);
  int on_top = 0;
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i) {
      const double cover = surface.boulder(i, j).cover;
      // Stones that lie on soil are green, too.
      if (cover == 0.0) {
        EXPECT_EQ(reflectance.at(i, j).b, 0.0F);
      }
      if (cover < 1.0 || surface.slope_deg(i, j) > 30.0) continue;
      sum += glm::dvec3(reflectance.at(i, j));
      ++on_top;
    }
  ASSERT_GT(on_top, 500);
  // The rock's albedo on three quarters, lichens' on a quarter.
  EXPECT_NEAR(sum.g * std::numbers::pi / on_top, 0.758 * 0.3 + 0.242 * 0.268, 0.05);
  EXPECT_NEAR(sum.b * std::numbers::pi / on_top, 0.242 * 0.215, 0.02);
}

}  // namespace
}  // namespace wold::terrain
