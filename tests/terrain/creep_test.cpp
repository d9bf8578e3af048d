#include "terrain/creep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/parallel.h"

namespace wold::terrain {
namespace {

double total(const GroundMap<double>& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0);
}

/// One sample of 1 m among others of 0.
GroundMap<double> spike(int samples, double size_m, int i, int j) {
  GroundMap<double> heights_m(samples, size_m);
  heights_m.at(i, j) = 1.0;
  return heights_m;
}

/// On maps with more and fewer samples per length of creep.
class Creep : public testing::TestWithParam<int> {};

TEST_P(Creep, DampsAWaveAsDiffusionDoes) {
  // cos(k x) decays as exp(-k^2 D t); samples half a step inside the border see it as a mirror.
  const int samples = GetParam();
  const double size_m = 10.0, step_m = size_m / (samples - 1), length2_m2 = 0.1;
  const double k = 4.0 * std::numbers::pi / (size_m + step_m);
  const auto wave = [&](int i) { return std::cos(k * (i + 0.5) * step_m); };
  GroundMap<double> heights_m(samples, size_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) heights_m.at(i, j) = wave(i) + 2.0 * wave(j);
  creep(heights_m, length2_m2);
  // The second difference sees k as 2 sin(k step / 2) / step.
  const double seen_per_m = 2.0 * std::sin(0.5 * k * step_m) / step_m;
  const double left = std::exp(-seen_per_m * seen_per_m * length2_m2);
  EXPECT_NEAR(left, std::exp(-k * k * length2_m2), 0.1 * step_m);
  for (const auto& [i, j] : {std::pair(0, 0), {3, 7}, {samples - 1, samples / 2}})
    EXPECT_NEAR(heights_m.at(i, j), left * (wave(i) + 2.0 * wave(j)), 1e-8);
}

TEST_P(Creep, SpreadsASpikeAsABell) {
  // Over an unbounded plane: exp(-r^2 / (4 D t)) / (4 pi D t) per square metre.
  const int samples = GetParam(), middle = samples / 2;
  const double size_m = 10.0, length2_m2 = 0.25;
  GroundMap<double> heights_m = spike(samples, size_m, middle, middle);
  creep(heights_m, length2_m2);
  EXPECT_NEAR(total(heights_m), 1.0, 1e-12);
  const double step2_m2 = heights_m.step_m() * heights_m.step_m();
  const double top = step2_m2 / (4.0 * std::numbers::pi * length2_m2);
  EXPECT_NEAR(heights_m.at(middle, middle), top, top * 0.15 * step2_m2 / length2_m2);
  const int aside = static_cast<int>(std::lround(1.0 / heights_m.step_m()));
  EXPECT_NEAR(heights_m.at(middle + aside, middle), top * std::exp(-0.25 / length2_m2),
              top * 0.15 * step2_m2 / length2_m2);
  EXPECT_NEAR(heights_m.at(middle + aside, middle), heights_m.at(middle, middle - aside), 1e-15);
}

TEST_P(Creep, LosesNothingOverTheBorder) {
  GroundMap<double> heights_m = spike(GetParam(), 3.0, 0, GetParam() - 2);
  creep(heights_m, 4.0);
  EXPECT_NEAR(total(heights_m), 1.0, 1e-12);
  const auto [low, high] =
      std::minmax_element(heights_m.values().begin(), heights_m.values().end());
  EXPECT_GT(*low, 0.0);
  EXPECT_LT(*high / *low, 3.0);  // it has gone farther than the map is wide
}

INSTANTIATE_TEST_SUITE_P(Samples, Creep, testing::Values(33, 101, 401));

TEST(CreepOnAnyMap, LeavesLevelGroundAlone) {
  GroundMap<double> heights_m(65, 8.0, 1234.567);
  creep(heights_m, 0.1);
  EXPECT_EQ(std::ranges::count(heights_m.values(), 1234.567), 65 * 65);
}

TEST(CreepOnAnyMap, LeavesGroundAloneThatIsCoarserThanItReaches) {
  GroundMap<double> heights_m = spike(17, 16000.0, 8, 8);
  creep(heights_m, 0.1);
  EXPECT_NEAR(heights_m.at(8, 8), 1.0, 1e-6);
}

TEST(CreepOnAnyMap, IsTheSameOnAnyNumberOfThreads) {
  const GroundMap<double> before_m = spike(129, 8.0, 20, 100);
  GroundMap<double> many = before_m;
  creep(many, 0.5);
  const ThreadLimit one(1);
  GroundMap<double> single = before_m;
  creep(single, 0.5);
  EXPECT_EQ(many.values(), single.values());
}

}  // namespace
}  // namespace wold::terrain
