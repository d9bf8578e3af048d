#include "cloud/fibres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace wold::cloud {
namespace {

constexpr double cell_m = 16000.0;
const glm::dvec2 period_m(128000.0, 64000.0);
constexpr int held = 5;

/// Of the wind to the east.
Recipe combed() {
  Recipe recipe = recipe_of(scene::CloudKind::cirrus);
  recipe.trails.heading_rad = 0.5 * std::numbers::pi;
  return recipe;
}

template <class Value>
double mean_square(const Value& value) {
  constexpr int places = 20000;
  double sum = 0.0;
  for (std::uint64_t i = 0; i < places; ++i) {
    const double x = value(period_m * glm::dvec2(random_uniform({i, 0}), random_uniform({i, 1})));
    sum += x * x / places;
  }
  return sum;
}

TEST(Fibres, AreFarLongerThanWide) {
  const Fibres fibres(combed(), held, cell_m, period_m, 3);
  const auto change = [&](const glm::dvec2& step_m) {
    return mean_square(
        [&](const glm::dvec2& at) { return fibres.at(at + step_m, 0.0) - fibres.at(at, 0.0); });
  };
  EXPECT_GT(change({0.0, 60.0}), 4.0 * change({60.0, 0.0}));
  EXPECT_LT(change({60.0, 0.0}), 0.3 * change({2000.0, 0.0}));
}

TEST(Fibres, AddNothingOnTheWholeAndNoMoreThanTheirHighest) {
  const Fibres fibres(combed(), held, cell_m, period_m, 3);
  double sum = 0.0, highest = 0.0;
  constexpr int places = 40000;
  for (std::uint64_t i = 0; i < places; ++i) {
    const double value =
        fibres.at(period_m * glm::dvec2(random_uniform({i, 2}), random_uniform({i, 3})), 0.0);
    sum += value;
    highest = std::max(highest, value);
  }
  EXPECT_NEAR(sum / places, 0.0, 0.02);
  EXPECT_GT(highest, 0.5 * fibres.max());
  EXPECT_LE(highest, fibres.max());
}

TEST(Fibres, FadeWhereTheyAreFinerThanWhatIsSeen) {
  const Fibres fibres(combed(), held, cell_m, period_m, 3);
  const auto power = [&](double footprint_m) {
    return mean_square([&](const glm::dvec2& at) { return fibres.at(at, footprint_m); });
  };
  EXPECT_GT(power(0.0), 0.05);
  EXPECT_LT(power(60.0), 0.9 * power(0.0));
  EXPECT_LT(power(240.0), 0.8 * power(60.0));
  EXPECT_EQ(power(5000.0), 0.0);
}

TEST(Fibres, AreNoneWhereTheMapHoldsAllOctaves) {
  const Fibres none(combed(), combed().masses.count, cell_m, period_m, 3);
  EXPECT_EQ(none.at({123.0, 456.0}, 0.0), 0.0);
  EXPECT_EQ(none.max(), 0.0);
}

TEST(Fibres, RepeatWithTheirLayer) {
  const Fibres fibres(combed(), held, cell_m, period_m, 3);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 at(i * 317.0, i * 211.0);
    EXPECT_NEAR(fibres.at(at + period_m * glm::dvec2(2.0, -1.0), 0.0), fibres.at(at, 0.0), 1e-6);
  }
}

}  // namespace
}  // namespace wold::cloud
