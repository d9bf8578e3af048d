#include "place/dryness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold::place {
namespace {

const glm::dvec3 overhead(0.0, 0.0, 1.0);

// A ridge along the parallel: water leaves both of its sides alike, and the sun shines on one.
TEST(Dryness, IsMoreOnSunnySlopes) {
  Heightfield ridge(129, 1280.0);
  for (int j = 0; j < ridge.samples(); ++j)
    for (int i = 0; i < ridge.samples(); ++i)
      ridge.at(i, j) = static_cast<float>(-0.4 * std::abs(ridge.place_m(i, j).y - 640.0));
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.0, -1.0, 1.0));
  for (const double away_m : {100.0, 300.0, 500.0}) {
    const auto at = [&](const FactorMap& dryness, double north_m) {
      return double{dryness.sample(500.0, 640.0 + north_m)};
    };
    const FactorMap sunny = dryness_map(ridge, sun);
    EXPECT_GT(at(sunny, -away_m), at(sunny, away_m) + 1.0) << away_m;
    const FactorMap even = dryness_map(ridge, overhead);
    EXPECT_NEAR(at(even, -away_m), at(even, away_m), 0.15) << away_m;
  }
}

// A valley that falls to the south: water gathers in its middle, spurs beside it are dry.
TEST(Dryness, IsLeastWhereWaterGathers) {
  Heightfield valley(129, 1280.0);
  for (int j = 0; j < valley.samples(); ++j)
    for (int i = 0; i < valley.samples(); ++i)
      valley.at(i, j) = static_cast<float>(0.3 * std::abs(valley.place_m(i, j).x - 640.0) +
                                           0.02 * valley.place_m(i, j).y);
  const FactorMap dryness = dryness_map(valley, overhead);
  EXPECT_LT(dryness.sample(640.0, 300.0), -1.0F);
  EXPECT_GT(dryness.sample(200.0, 300.0), 0.0F);
  double sum = 0.0;
  for (const float value : dryness.values())
    sum += double{value} / static_cast<double>(dryness.values().size());
  EXPECT_NEAR(sum, 0.0, 0.1);
}

TEST(Dryness, IsFiniteOnLevelGround) {
  const FactorMap dryness = dryness_map(Heightfield(33, 320.0), overhead);
  for (const float value : dryness.values()) EXPECT_LE(std::abs(value), 2.5F);
}

}  // namespace
}  // namespace wold::place
