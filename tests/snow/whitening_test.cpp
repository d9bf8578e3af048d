#include "snow/whitening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.h"

namespace wold::snow {
namespace {

double mean(const FactorMap& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0) /
         static_cast<double>(map.values().size());
}

Heightfield hummocks() {
  Heightfield terrain(65, 8.0);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      terrain.at(i, j) = static_cast<float>(0.05 * std::sin(0.7 * i) * std::sin(0.5 * j));
  return terrain;
}

FactorMap even(double fraction, double size_m = 8.0) {
  return {2, size_m, static_cast<float>(fraction)};
}

TEST(CoverFraction, IsOfNiuAndYang) {
  EXPECT_EQ(cover_fraction(0.0), 0.0);
  EXPECT_NEAR(cover_fraction(1.25), 0.4621, 5e-5);  // tanh(1/2)
  EXPECT_EQ(cover_fraction(1e4), 1.0);
}

TEST(WhiteRamp, HasTheShareAsItsMeanHoweverSoftItIs) {
  for (double ramp : {1e-6, 0.05, 0.6, 1.0, 1.7, 30.0})
    for (double fraction : {0.0, 0.004, 0.1, 0.37, 0.5, 0.8, 0.995, 1.0}) {
      constexpr int places = 20000;
      double sum = 0.0;
      for (int i = 0; i < places; ++i)
        sum += white((i + 0.5) / places, threshold(fraction, ramp), ramp);
      EXPECT_NEAR(sum / places, fraction, 1e-4) << ramp << ' ' << fraction;
    }
}

TEST(WhitePatches, CoverTheShareOnFineCoarseAndSmallMaps) {
  for (int samples : {400, 65, 9}) {
    const WhitePatches patches(hummocks(), samples, 0.35, 11);
    for (double fraction : {0.0, 0.03, 0.2, 0.5, 0.77, 0.98, 1.0})
      EXPECT_NEAR(mean(patches.white_map(even(fraction))), fraction, 0.01) << samples;
  }
  const WhitePatches min(Heightfield(2, 1.0), 2, 0.35, 1);
  EXPECT_EQ(mean(min.white_map(even(0.0, 1.0))), 0.0);
  EXPECT_EQ(mean(min.white_map(even(1.0, 1.0))), 1.0);
}

TEST(WhitePatches, OnlyGrowWhileTheShareDoes) {
  const WhitePatches patches(hummocks(), 200, 0.35, 11);
  FactorMap before = patches.white_map(even(0.0));
  for (double fraction = 0.01; fraction <= 1.0; fraction += 0.01) {
    const FactorMap now = patches.white_map(even(fraction));
    for (std::size_t i = 0; i < now.values().size(); ++i)
      ASSERT_GE(now.values()[i], before.values()[i]);
    before = now;
  }
}

TEST(WhitePatches, ArePatchesWithNarrowEdgesWhereTheMapIsFineAndGreyWhereItIsCoarse) {
  const auto grey_fraction = [](int samples, double size_m) {
    const WhitePatches patches(Heightfield(2, size_m), samples, 0.35, 11);
    const FactorMap map = patches.white_map(even(0.5, size_m));
    return static_cast<double>(std::ranges::count_if(
               map.values(), [](float w) { return w > 0.001F && w < 0.999F; })) /
           static_cast<double>(map.values().size());
  };
  EXPECT_LT(grey_fraction(801, 8.0), 0.15);
  EXPECT_GT(grey_fraction(101, 1000.0), 0.999);
}

TEST(WhitePatches, LieFirstInHollows) {
  const Heightfield terrain = hummocks();
  const FactorMap map = WhitePatches(terrain, 257, 0.35, 11).white_map(even(0.3));
  double low = 0.0, high = 0.0;
  int lows = 0, highs = 0;
  for (int j = 0; j < 257; ++j)
    for (int i = 0; i < 257; ++i) {
      const float height_m = terrain.sample(i * map.step_m(), j * map.step_m());
      if (height_m < -0.02F) low += map.at(i, j), ++lows;
      if (height_m > 0.02F) high += map.at(i, j), ++highs;
    }
  EXPECT_GT(low / lows, high / highs + 0.1);
}

}  // namespace
}  // namespace wold::snow
