#include "terrain/grazing_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wold::terrain {
namespace {

/// A slope that rises to the east.
struct Slope {
  double rise;

  explicit Slope(double deg) : rise(std::tan(deg * std::numbers::pi / 180.0)) {}
  Trodden at(const GrazingSteps& steps, const glm::dvec2& at_m, double step_m) const {
    return steps.at({at_m, rise * at_m.x}, {rise, 0.0}, step_m);
  }
  /// Over 60 m by 60 m.
  template <class Value>
  double mean(const GrazingSteps& steps, double step_m, const Value& value) const {
    constexpr int side = 600;
    double sum = 0.0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) sum += value(at(steps, {0.1 * i, 0.1 * j}, step_m));
    return sum / (side * side);
  }
};

double bare(const Trodden& place) { return place.bare; }

TEST(GrazingSteps, AreOnSteepMeadowsAlone) {
  const GrazingSteps steps(1.0, 3);
  EXPECT_EQ(Slope(14.0).mean(steps, 0.1, bare), 0.0);
  EXPECT_EQ(Slope(43.0).mean(steps, 0.1, bare), 0.0);
  EXPECT_GT(Slope(27.0).mean(steps, 0.1, bare), 0.25);
}

// A tread for every 0.7 m of height.
TEST(GrazingSteps, FollowEachOtherUpTheSlope) {
  const GrazingSteps steps(1.0, 3);
  const Slope slope(27.0);
  int treads = 0;
  constexpr int lines = 20;
  for (int line = 0; line < lines; ++line) {
    bool on_tread = slope.at(steps, {0.0, 3.0 * line}, 0.02).level > 0.3;
    for (double east_m = 0.0; east_m < 100.0; east_m += 0.02) {
      const double level = slope.at(steps, {east_m, 3.0 * line}, 0.02).level;
      const bool now = on_tread ? level > 0.15 : level > 0.3;
      if (now && !on_tread) ++treads;
      on_tread = now;
    }
  }
  const double wanted = 100.0 * slope.rise / 0.7;
  EXPECT_NEAR(1.0 * treads / lines, wanted, 0.05 * wanted);
}

TEST(GrazingSteps, LeaveTheSlopeAsItIsOnTheWhole) {
  const GrazingSteps steps(1.0, 3);
  const Slope slope(27.0);
  EXPECT_NEAR(slope.mean(steps, 0.05, [](const Trodden& place) { return place.gradient.x; }), 0.0,
              0.02 * slope.rise);
  for (double east_m = 10.0; east_m < 12.0; east_m += 0.02) {
    const Trodden place = slope.at(steps, {east_m, 5.0}, 0.02);
    if (place.level > 0.5) {
      EXPECT_LT(place.gradient.x, -0.3 * slope.rise) << east_m;
    }
    if (place.level == 0.0) {
      EXPECT_GT(place.gradient.x, 0.2 * slope.rise) << east_m;
    }
  }
}

TEST(GrazingSteps, WearAsMuchOnMapsOfAnyStep) {
  const GrazingSteps steps(0.7, 3);
  const Slope slope(27.0);
  const double fine = slope.mean(steps, 0.05, bare);
  for (const double step_m : {0.3, 1.0, 10.0})
    EXPECT_NEAR(slope.mean(steps, step_m, bare), fine, 0.03 * fine) << step_m;
  const Trodden coarse = slope.at(steps, {30.0, 30.0}, 10.0);
  EXPECT_EQ(coarse.gradient, glm::dvec2(0.0));
  EXPECT_EQ(coarse.level, 0.0);
}

TEST(GrazingSteps, AreOnAShareOfSuchSlopes) {
  const Slope slope(27.0);
  for (const double share : {0.2, 0.5, 0.8}) {
    const GrazingSteps steps(share, 9);
    constexpr int side = 100;
    int trodden = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        if (slope.at(steps, {23.0 * i, 23.0 * j}, 50.0).bare > 0.15) ++trodden;
    EXPECT_NEAR(1.0 * trodden / (side * side), share, 0.06) << share;
  }
  EXPECT_EQ(slope.mean(GrazingSteps(0.0, 9), 1.0, bare), 0.0);
}

}  // namespace
}  // namespace wold::terrain
