#include "terrain/erosion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/noise.h"
#include "core/parallel.h"

namespace wold::terrain {
namespace {

/// Steep fractal ground, 64 x 64 samples of 0.25 m.
GroundMap<double> rugged() {
  const Fbm relief(3, 5, 0.6);
  GroundMap<double> heights_m(65, 16.0);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i) heights_m.at(i, j) = 2.0 * relief.at(glm::dvec2(i, j) / 16.0);
  return heights_m;
}

double total(const GroundMap<double>& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0);
}

/// Largest slope between neighbours, diagonal ones included.
double steepest(const GroundMap<double>& map) {
  double largest = 0.0;
  for (int j = 0; j + 1 < map.samples(); ++j)
    for (int i = 0; i + 1 < map.samples(); ++i) {
      const double h = map.at(i, j);
      largest = std::max({largest, std::abs(map.at(i + 1, j) - h), std::abs(map.at(i, j + 1) - h),
                          std::abs(map.at(i + 1, j + 1) - h) / std::numbers::sqrt2});
    }
  return largest / map.step_m();
}

TEST(Erosion, KeepsTheMassAndTheLimit) {
  GroundMap<double> heights_m = rugged();
  const double before = total(heights_m);
  const double limit = std::tan(33.0 * std::numbers::pi / 180.0);
  ASSERT_GT(steepest(heights_m), 1.5 * limit);
  slide(heights_m, 33.0, 2000);
  EXPECT_NEAR(total(heights_m), before, 1e-9);
  EXPECT_LT(steepest(heights_m), 1.01 * limit);
}

TEST(Erosion, LeavesStableGroundAlone) {
  GroundMap<double> heights_m(33, 8.0);
  for (int j = 0; j < 33; ++j)
    for (int i = 0; i < 33; ++i) heights_m.at(i, j) = 0.4 * i * heights_m.step_m();  // 22 degrees
  const GroundMap<double> before = heights_m;
  slide(heights_m, 30.0, 50);
  EXPECT_EQ(heights_m.values(), before.values());
}

TEST(Erosion, IsTheSameOnAnyNumberOfThreads) {
  GroundMap<double> many = rugged();
  slide(many, 33.0, 20);
  const ThreadLimit one(1);
  GroundMap<double> single = rugged();
  slide(single, 33.0, 20);
  EXPECT_EQ(many.values(), single.values());
}

}  // namespace
}  // namespace wold::terrain
