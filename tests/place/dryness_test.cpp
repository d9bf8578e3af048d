#include "place/dryness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold::place {
namespace {

// A valley that falls to the south: water gathers in its middle, spurs beside it are dry.
TEST(Dryness, IsLeastWhereWaterGathers) {
  Heightfield valley(129, 1280.0);
  for (int j = 0; j < valley.samples(); ++j)
    for (int i = 0; i < valley.samples(); ++i)
      valley.at(i, j) = static_cast<float>(0.3 * std::abs(valley.place_m(i, j).x - 640.0) +
                                           0.02 * valley.place_m(i, j).y);
  const FactorMap dryness = dryness_map(valley);
  EXPECT_LT(dryness.sample(640.0, 300.0), -1.0F);
  EXPECT_GT(dryness.sample(200.0, 300.0), 0.0F);
  double sum = 0.0;
  for (const float value : dryness.values())
    sum += double{value} / static_cast<double>(dryness.values().size());
  EXPECT_NEAR(sum, 0.0, 0.1);
}

TEST(Dryness, IsFiniteOnLevelGround) {
  const FactorMap dryness = dryness_map(Heightfield(33, 320.0));
  for (const float value : dryness.values()) EXPECT_LE(std::abs(value), 2.5F);
}

}  // namespace
}  // namespace wold::place
