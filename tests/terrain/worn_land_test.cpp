#include "terrain/worn_land.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wold::terrain {
namespace {

/// All of it, on a grid of its own samples.
class WornLandTest : public testing::Test {
 protected:
  static constexpr int side = 512;

  static glm::dvec2 place(int i, int j) {
    return glm::dvec2(i, j) * (1.0 * WornLand::period / side);
  }
  static double height(const glm::dvec2& at) {
    double sum = 0.0;
    for (int octave = 0; octave < WornLand::octaves; ++octave) sum += land().height(octave, at);
    return sum;
  }
  static const WornLand& land() {
    static const WornLand land(7);
    return land;
  }
};

TEST_F(WornLandTest, HasMeanZeroAndDeviationOne) {
  double sum = 0.0, squares = 0.0;
  for (int j = 0; j < side; j += 4)
    for (int i = 0; i < side; i += 4) {
      const double value = height(place(i, j));
      sum += value;
      squares += value * value;
    }
  const double count = side * side / 16.0;
  EXPECT_NEAR(sum / count, 0.0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.03);
}

// No seam: beyond one side of the tile is the opposite one, and across it the land is as smooth as
// elsewhere.
TEST_F(WornLandTest, RepeatsWithoutASeam) {
  const auto bend_across = [](double east) {
    double sum = 0.0;
    constexpr double step = 0.01;
    for (double north = 0.0; north < WornLand::period; north += 0.05)
      sum += std::abs(height({east + step, north}) + height({east - step, north}) -
                      2.0 * height({east, north}));
    return sum;
  };
  double mean = 0.0;
  constexpr int columns = 40;
  for (int i = 1; i <= columns; ++i) {
    const double east = i * 0.097;
    EXPECT_NEAR(height({east, 0.7}), height({east - WornLand::period, 0.7 + WornLand::period}),
                1e-9);
    mean += bend_across(east) / columns;
  }
  EXPECT_LT(bend_across(0.0), 1.4 * mean);
}

// Streams have taken the pits: water finds its way. Of fractional Brownian motion (six octaves,
// Hurst 0.7) seven in a thousand of such samples are pits.
TEST_F(WornLandTest, HasNoPits) {
  int pits = 0, high = 0;
  for (int j = 0; j < side; j += 2)
    for (int i = 0; i < side; i += 2) {
      const double here = height(place(i, j));
      if (here < -0.9) continue;  // lowlands
      double lowest = here;
      for (int dj = -2; dj <= 2; ++dj)
        for (int di = -2; di <= 2; ++di)
          if (di != 0 || dj != 0) lowest = std::min(lowest, height(place(i + di, j + dj)));
      ++high;
      if (lowest >= here) ++pits;
    }
  EXPECT_GT(high, 30000);
  EXPECT_LT(pits, high / 2000);
}

// As those of mountains: half of the land is about as steep as the mean, few places are much
// steeper, since slopes creep, and there are no walls.
TEST_F(WornLandTest, HasSlopesOfMountains) {
  constexpr double feature_m = 8000.0, deviation_m = 300.0, step = 0.01;
  std::vector<double> slopes_deg;
  for (int j = 0; j < side; j += 5)
    for (int i = 0; i < side; i += 5) {
      const glm::dvec2 at = place(i, j);
      const double east = height(at + glm::dvec2(step, 0.0)) - height(at - glm::dvec2(step, 0.0));
      const double north = height(at + glm::dvec2(0.0, step)) - height(at - glm::dvec2(0.0, step));
      slopes_deg.push_back(180.0 / 3.14159265 *
                           std::atan(std::sqrt(east * east + north * north) / (2.0 * step) *
                                     deviation_m / feature_m));
    }
  std::ranges::sort(slopes_deg);
  EXPECT_GT(slopes_deg[slopes_deg.size() / 2], 10.0);
  EXPECT_LT(slopes_deg[slopes_deg.size() / 2], 25.0);
  EXPECT_LT(slopes_deg[slopes_deg.size() * 99 / 100], 55.0);
}

TEST_F(WornLandTest, KnowsWhereItIsSteep) {
  double mean = 0.0, lowlands = 0.0;
  int count = 0, low = 0;
  for (int j = 0; j < side; j += 4)
    for (int i = 0; i < side; i += 4) {
      const double steepness = land().steepness(place(i, j));
      mean += steepness;
      ++count;
      if (height(place(i, j)) > -1.0) continue;
      lowlands += steepness;
      ++low;
    }
  EXPECT_NEAR(mean / count, 1.0, 0.03);
  ASSERT_GT(low, 100);
  EXPECT_LT(lowlands / low, 0.2);
}

}  // namespace
}  // namespace wold::terrain
