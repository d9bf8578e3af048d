#include "terrain/finer_relief.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/noise.h"
#include "terrain/surface.h"

namespace wold::terrain {
namespace {

/// Ground that rises to the north, with relief of that deviation in the octaves above the cells of
/// 20 m.
GroundMap<double> rough_slope(double deviation_m, double hurst) {
  GroundMap<double> map(257, 2560.0);
  const Fbm relief{3, 6, hurst};
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      map.at(i, j) = 0.3 * at_m.y + deviation_m * relief.at(at_m / 640.0);
    }
  return map;
}

double mean_deviation(const Roughness& roughness) {
  double sum = 0.0;
  for (const float value : roughness.deviation_m.values())
    sum += double{value} / static_cast<double>(roughness.deviation_m.values().size());
  return sum;
}

TEST(Roughness, IsInProportionToTheGroundsAndNoneOnASlope) {
  const double once = mean_deviation(measured_roughness(rough_slope(10.0, 0.8), Held::exactly));
  const double twice = mean_deviation(measured_roughness(rough_slope(20.0, 0.8), Held::exactly));
  EXPECT_GT(once, 0.1);
  EXPECT_NEAR(twice / once, 2.0, 0.02);
  EXPECT_LT(mean_deviation(measured_roughness(rough_slope(0.0, 0.8), Held::exactly)), 0.01);
}

TEST(Roughness, FallsFasterWhereTheGroundIsSmoother) {
  const auto hurst = [](double of_ground) {
    return measured_roughness(rough_slope(10.0, of_ground), Held::exactly).hurst.at(128, 128);
  };
  EXPECT_GT(hurst(1.0), hurst(0.6) + 0.2F);
}

class FinerReliefTest : public testing::Test {
 protected:
  GroundMap<double> ground_ = rough_slope(20.0, 0.7);
  FinerRelief relief_{ground_, measured_roughness(ground_, Held::exactly), 0.9, 4};
};

// Under 2 m of it waves of some metres are hidden, those of a hundred are not.
TEST_F(FinerReliefTest, IsHiddenBySnowWhereItsWavesAreShort) {
  const auto hidden = [&](double step_m, double coarse_step_m, double depth_m) {
    const GroundGrid grid{{{900.0, 1100.0}, 256 * step_m}, 257};
    const FinerRelief::Weights weights = relief_.shown_below(coarse_step_m, step_m);
    const RowParts all = whole_rows(grid.samples);
    const auto snow_m = [depth_m](const glm::dvec2&) { return depth_m; };
    const GroundMap<glm::vec2> under_snow = relief_.hidden_by(snow_m, grid, weights, all);
    const GroundMap<FinerRelief::Bump> bare = relief_.on_grid(grid, weights, all);
    double hidden2 = 0.0, bare2 = 0.0;
    for (const glm::dvec2 slope : under_snow.values()) hidden2 += glm::dot(slope, slope);
    for (const FinerRelief::Bump& bump : bare.values())
      bare2 += glm::dot(bump.gradient, bump.gradient);
    return std::sqrt(hidden2 / bare2);
  };
  EXPECT_GT(hidden(0.25, 2.0, 2.0), 0.95);
  EXPECT_LE(hidden(0.25, 2.0, 2.0), 1.0);
  EXPECT_LT(hidden(8.0, 120.0, 2.0), 0.2);
  EXPECT_LT(hidden(0.25, 2.0, 0.2), 0.6);
  EXPECT_EQ(hidden(0.25, 2.0, 0.0), 0.0);
}

// The same whatever asks: a place, or a grid which evaluates large octaves at few places.
TEST_F(FinerReliefTest, IsTheSameOnAGrid) {
  const GroundGrid grid{{{900.0, 1100.0}, 64.0}, 257};
  const FinerRelief::Weights weights = relief_.shown_at(grid.step_m());
  const GroundMap<FinerRelief::Bump> map = relief_.on_grid(grid, weights, whole_rows(grid.samples));
  double apart2 = 0.0, height2 = 0.0, steeper2 = 0.0, steep2 = 0.0;
  for (int j = 0; j < grid.samples; j += 7)
    for (int i = 0; i < grid.samples; i += 7) {
      const FinerRelief::Bump want = relief_.at(map.place_m(i, j), weights);
      const FinerRelief::Bump got = map.at(i, j);
      apart2 += (got.height_m - want.height_m) * (got.height_m - want.height_m);
      height2 += want.height_m * want.height_m;
      steeper2 += glm::dot(got.gradient - want.gradient, got.gradient - want.gradient);
      steep2 += glm::dot(want.gradient, want.gradient);
    }
  EXPECT_GT(height2, 0.0);
  EXPECT_LT(std::sqrt(apart2 / height2), 0.1);
  EXPECT_LT(std::sqrt(steeper2 / steep2), 0.2);
}

// Steepest ascent is that of the heights, but for how roughness changes and the fall line turns.
TEST_F(FinerReliefTest, HasTheSlopesOfItsHeights) {
  const FinerRelief::Weights weights = relief_.shown_at(8.0);
  constexpr double step_m = 0.05;
  double together = 0.0, steep2 = 0.0, said2 = 0.0;
  for (int k = 0; k < 500; ++k) {
    const glm::dvec2 at_m(300.0 + 3.9 * k, 2100.0 - 3.1 * k);
    const auto height_m = [&](double east_m, double north_m) {
      return relief_.at(at_m + glm::dvec2(east_m, north_m), weights).height_m;
    };
    const glm::dvec2 rise(height_m(step_m, 0.0) - height_m(-step_m, 0.0),
                          height_m(0.0, step_m) - height_m(0.0, -step_m));
    const glm::dvec2 want = rise / (2.0 * step_m);
    const glm::dvec2 said = relief_.at(at_m, weights).gradient;
    together += glm::dot(said, want);
    said2 += glm::dot(said, said);
    steep2 += glm::dot(want, want);
  }
  EXPECT_GT(together / std::sqrt(said2 * steep2), 0.8);
  EXPECT_NEAR(std::sqrt(said2 / steep2), 1.0, 0.2);
}

// On a slope that falls to the south channels run north and south: heights change less along them.
TEST_F(FinerReliefTest, RunsDownTheFallLine) {
  const GroundMap<double> slope = rough_slope(4.0, 0.7);
  const FinerRelief relief(slope, measured_roughness(slope, Held::exactly), 0.9, 4);
  const FinerRelief::Weights weights = relief.shown_at(4.0);
  double down2 = 0.0, across2 = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const glm::dvec2 gradient = relief.at({300.0 + 0.97 * k, 2200.0 - 0.83 * k}, weights).gradient;
    across2 += gradient.x * gradient.x;
    down2 += gradient.y * gradient.y;
  }
  EXPECT_GT(across2, 1.5 * down2);
}

TEST_F(FinerReliefTest, LightOnItsSurfaceIsTheGroundsOnTheMean) {
  const Heightfield level(65, 2560.0);
  const GroundGrid grid{{{1000.0, 1000.0}, 256.0}, 257};
  const Surface surface(level, &relief_, grid);
  GroundLight light{ColourMap(2, grid.square, glm::vec3(0.8F)),
                    ColourMap(2, grid.square, glm::vec3(0.2F)), FactorMap(2, grid.square, 1.0F)};
  const GroundLight lit = surface.lit(light, glm::normalize(glm::dvec3(1.0, 0.0, 1.0)));
  double sun = 0.0, spread = 0.0;
  for (const glm::vec3& value : lit.sun.values()) {
    sun += double{value.g} / static_cast<double>(lit.sun.values().size());
    spread += std::abs(double{value.g} - 0.8) / static_cast<double>(lit.sun.values().size());
  }
  EXPECT_NEAR(sun, 0.8, 0.05);
  EXPECT_GT(spread, 0.02);
}

// Deep snow is lit as what is level, not as the waves below it.
TEST_F(FinerReliefTest, ShowsNothingInLightUnderDeepSnow) {
  const Heightfield level(65, 2560.0);
  const GroundGrid grid{{{1000.0, 1000.0}, 25.6}, 257};
  const auto unevenness = [&](double depth_m) {
    const Surface surface(level, &relief_, grid, {}, {},
                          {[depth_m](const glm::dvec2&) { return depth_m; }, {}});
    const ColourMap one(2, grid.square, glm::vec3(1.0F));
    const GroundLight light =
        surface.lit({one, one, FactorMap(2, grid.square, 1.0F)}, {0.6, 0.0, 0.8});
    double sum2 = 0.0;
    for (const glm::vec3& sun : light.sun.values()) sum2 += (sun.g - 1.0F) * (sun.g - 1.0F);
    return std::sqrt(sum2 / static_cast<double>(light.sun.values().size()));
  };
  EXPECT_LT(unevenness(30.0), 0.2 * unevenness(0.0));
  EXPECT_LT(unevenness(0.5), unevenness(0.0));
}

// However low the sun is: it faces it as the ground does.
TEST(Surface, IsLitAsTheGroundWhereItIsHardlyCarved) {
  const Heightfield level(2, 64.0);
  const GroundGrid grid{{.size_m = 64.0}, 65};
  const auto carved = [](const glm::dvec2&, double) { return glm::dvec2(1e-5, 0.0); };
  const Surface surface(level, nullptr, grid, {}, {},
                        {[](const glm::dvec2&) { return 1.0; }, carved});
  const ColourMap one(2, grid.square, glm::vec3(1.0F));
  const GroundLight light = surface.lit({one, one, FactorMap(2, grid.square, 1.0F)},
                                        glm::normalize(glm::dvec3(1.0, 0.0, 0.05)));
  EXPECT_NEAR(light.sun.at(30, 30).g, 1.0, 1e-3);
}

// What is carved turns level ground by its slope; where nothing is, light is the ground's.
TEST(Surface, IsLitAsItsSnowIsCarved) {
  const Heightfield level(2, 64.0);
  const GroundGrid grid{{.size_m = 64.0}, 65};
  const auto carved = [](const glm::dvec2& at_m, double step_m) {
    return at_m.x > 32.0 ? glm::dvec2(-0.5 * step_m, 0.0) : glm::dvec2(0.0);
  };
  const Surface surface(level, nullptr, grid, {}, {},
                        {[](const glm::dvec2&) { return 1.0; }, carved});
  const ColourMap one(2, grid.square, glm::vec3(1.0F));
  const GroundLight light =
      surface.lit({one, one, FactorMap(2, grid.square, 1.0F)}, {0.6, 0.0, 0.8});
  EXPECT_EQ(light.sun.at(10, 30).g, 1.0F);
  const double faces_sun = (0.8 + 0.5 * 0.6) / std::sqrt(1.25);
  EXPECT_NEAR(light.sun.at(50, 30).g, faces_sun / 0.8, 1e-4);
  EXPECT_EQ(surface.slope_deg(50, 30), 0.0);  // the ground's
}

}  // namespace
}  // namespace wold::terrain
