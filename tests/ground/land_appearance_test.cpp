#include "ground/land_appearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace wold::ground {
namespace {

const glm::dvec3 level(0.0, 0.0, 1.0);
constexpr glm::vec3 dark(0.02F), bright(0.06F);

/// Level places of all heights: those of the upper half are brighter.
LandAppearance of_heights(double range_m) {
  constexpr int count = 400;
  std::vector<LandSample> samples;
  for (int i = 0; i < count; ++i)
    samples.push_back({level, range_m * i / count, 2 * i < count ? dark : bright});
  return LandAppearance(samples);
}

TEST(LandAppearance, DiffersByHeightOnMountains) {
  const LandAppearance land = of_heights(1500.0);
  EXPECT_NEAR(land.at(level, 300.0).g, dark.g, 0.05 * dark.g);
  EXPECT_NEAR(land.at(level, 1200.0).g, bright.g, 0.05 * bright.g);
}

// Else the middle of a meadow's heights is a line along a contour of all the land around.
TEST(LandAppearance, OfASmallMeadowIsItsMeanAtAllHeights) {
  const LandAppearance land = of_heights(10.0);
  for (const double height_m : {-500.0, 1.0, 9.0, 500.0})
    EXPECT_NEAR(land.at(level, height_m).g, 0.5F * (dark.g + bright.g), 0.1 * dark.g) << height_m;
}

// By Nadaraya and Watson's regression: what lies as it does, and nothing of what lies otherwise.
TEST(LandAppearance, DiffersByAspect) {
  std::vector<LandSample> samples;
  for (int i = 0; i < 360; ++i) {
    const double aspect = i * 0.0174533;
    const glm::dvec3 up =
        glm::normalize(glm::dvec3(0.6 * std::sin(aspect), 0.6 * std::cos(aspect), 1.0));
    samples.push_back({up, 100.0, up.y < 0.0 ? bright : dark});
  }
  const LandAppearance land(samples);
  EXPECT_NEAR(land.at(glm::normalize(glm::dvec3(0.0, -0.6, 1.0)), 100.0).g, bright.g,
              0.05 * bright.g);
  EXPECT_NEAR(land.at(glm::normalize(glm::dvec3(0.0, 0.6, 1.0)), 100.0).g, dark.g, 0.05 * bright.g);
}

TEST(LandAppearance, KnowsHowPlacesDifferFromTheirMean) {
  std::vector<LandSample> samples;
  for (int i = 0; i < 400; ++i)
    samples.push_back({{0.0, 0.0, 1.0}, 1.0 * i, glm::vec3(i % 2 == 0 ? 0.06F : 0.04F)});
  const LandAppearance land(samples);
  EXPECT_NEAR(land.at({0.0, 0.0, 1.0}, 200.0).r, 0.05F, 0.001F);
  EXPECT_NEAR(land.variety().at(1.0, 1.0).r, 0.2F, 0.01F);
  EXPECT_NEAR(land.variety().at(-1.0, 1.0).r, -0.2F, 0.01F);
}

}  // namespace
}  // namespace wold::ground
