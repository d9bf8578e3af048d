#include "core/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"

namespace wold {
namespace {

TEST(Noise, IsZeroOnTheLatticeAndBounded) {
  double largest = 0.0;
  for (int i = -20; i < 20; ++i)
    for (int j = -20; j < 20; ++j) {
      EXPECT_EQ(gradient_noise({i, j}, 7), 0.0);
      largest = std::max(largest, std::abs(gradient_noise({i + 0.5, j + 0.37}, 7)));
    }
  EXPECT_GT(largest, 0.3);
  EXPECT_LE(largest, 0.7072);  // sqrt(dimension) / 2 with unit gradients
}

TEST(Noise, SlopesAreThoseOfItsHeights) {
  constexpr double step = 1e-6;
  const auto height = [](double x, double y) { return gradient_noise_slope({x, y}, 7).value; };
  for (int k = -50; k < 50; ++k) {
    const double x = 0.37 * k + 0.11, y = 0.53 * k - 0.29;
    const NoiseSlope noise = gradient_noise_slope({x, y}, 7);
    EXPECT_NEAR(noise.gradient.x, (height(x + step, y) - height(x - step, y)) / (2.0 * step), 1e-8);
    EXPECT_NEAR(noise.gradient.y, (height(x, y + step) - height(x, y - step)) / (2.0 * step), 1e-8);
    EXPECT_EQ(height(k, 3 - k), 0.0);
  }
}

TEST(Noise, RepeatsExactlyAfterItsPeriod) {
  const Fbm shape{11, 4, 0.8, 5};
  for (int k = 0; k < 50; ++k) {
    const glm::dvec2 at(k * 0.125 - 3.0, k * 0.0625);  // sums with the period are exact
    EXPECT_EQ(gradient_noise(at, 3, 5), gradient_noise(at + glm::dvec2(5.0, -10.0), 3, 5));
    EXPECT_NEAR(shape.at(at), shape.at(at + glm::dvec2(-5.0, 15.0)), 1e-9);
    EXPECT_NE(gradient_noise(at + 0.03, 3, 5), gradient_noise(at + 0.03, 4, 5));
  }
}

TEST(Noise, HasUnitDeviation) {
  const Fbm shape{5, 5, 0.7, 0};
  const int samples = 400;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const double value = shape.at({i * 0.37, j * 0.37});
      sum += value;
      squares += value * value;
    }
  const double count = samples * samples;
  EXPECT_NEAR(sum / count, 0.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.03);
}

/// Mean squared difference of an fBm over a distance.
double variogram(const Fbm& shape, double distance) {
  double sum = 0.0;
  const int samples = 160;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const glm::dvec2 at(i * 0.731, j * 0.677);
      const double across = shape.at(at + glm::dvec2(distance, 0.0)) - shape.at(at);
      sum += across * across;
    }
  return sum / (samples * samples);
}

TEST(Noise, VariogramFollowsTheHurstExponent) {
  for (const double hurst : {0.5, 0.7}) {
    const Fbm shape{17, 9, hurst, 0};
    const double slope = std::log10(variogram(shape, 0.125) / variogram(shape, 0.0125));
    EXPECT_NEAR(slope, 2.0 * hurst, 0.15);
  }
}

TEST(ScaleFreeNoise, ShowsOfFineFeaturesWhatAMapOfThatStepDoes) {
  const ScaleFreeNoise::Sizes sizes{200.0, 0.5};
  const ScaleFreeNoise fine(5, sizes, 0.1, 0.01), coarse(5, sizes, 0.1, 8.0);
  for (int k = 0; k < 50; ++k) {
    const glm::dvec2 at_m(k * 7.31, k * 3.77);
    EXPECT_NEAR(fine.at(at_m, 8.0), coarse.at(at_m), 1e-12);
    EXPECT_EQ(fine.at(at_m, 1e-3), fine.at(at_m));
  }
  EXPECT_NEAR(fine.shown(8.0), coarse.shown(), 1e-12);
  EXPECT_GT(fine.shown(8.0), 0.2);
  EXPECT_LT(fine.shown(8.0), 0.8);
}

// A distance to the nearest of some points changes by no more than the way that one goes, whatever
// cell the nearest one is in.
TEST(CellNoise, IsADistanceAcrossCells) {
  const double step = 0.01;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const glm::dvec2 at(40.0 * random_uniform({1, i, 0, 0}), 40.0 * random_uniform({1, i, 1, 0}));
    const double angle = 6.28 * random_uniform({1, i, 2, 0});
    const glm::dvec2 there = at + step * glm::dvec2(std::cos(angle), std::sin(angle));
    const double change = cell_noise(there, 5, glm::ivec2(40)) - cell_noise(at, 5, glm::ivec2(40));
    ASSERT_LE(std::abs(change), step + 1e-9) << at.x << ' ' << at.y;
  }
}

TEST(DomeNoise, IsTheHighestOfAllDomesAndRepeatsExactly) {
  const glm::ivec2 period(4, 6);
  constexpr double spread = 0.75, step = 1.0 / 64.0;
  double lowest = 9.0, highest = -9.0;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 384; ++j) {
      const glm::dvec2 at(i * step, j * step);
      const double value = dome_noise(at, 3, period, spread);
      ASSERT_EQ(value, dome_noise(at + glm::dvec2(-4.0, 12.0), 3, period, spread));
      // A dome that is left out would be a step: no dome that is seen is steeper than this.
      for (const glm::dvec2& beside : {glm::dvec2(step, 0.0), glm::dvec2(0.0, step)})
        ASSERT_NEAR(value, dome_noise(at + beside, 3, period, spread), 4.2 * step);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  EXPECT_LE(highest, std::exp(spread));
  EXPECT_GT(highest, 1.3);  // one of the larger domes
  EXPECT_GE(lowest, std::exp(-spread) - 2.0);
  EXPECT_LT(lowest, 0.0);
}

TEST(DomeNoise, WithoutSpreadIsTheDistanceToPoints) {
  const glm::ivec2 period(3, 5);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 at(i * 0.0173, i * 0.0311);
    const double distance = cell_noise(at, 9, period);
    EXPECT_NEAR(dome_noise(at, 9, period, 0.0), 1.0 - distance * distance, 1e-12);
  }
}

}  // namespace
}  // namespace wold
