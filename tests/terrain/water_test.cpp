#include "terrain/water.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wold::terrain {
namespace {

constexpr double size_m = 3000.0, radius_m = 600.0, level_m = 50.0;
const glm::dvec2 middle_m(1500.0);

/// A round lake, by steps of 15 m: cells of 30 m.
Lakes round_lake() {
  Lakes lakes{GroundMap<int>(201, size_m, -1), {level_m}};
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 201; ++i)
      if (glm::length(lakes.number.place_m(i, j) - middle_m) < radius_m) lakes.number.at(i, j) = 0;
  return lakes;
}

double area_m2(const Water& water, double step_m) {
  double area = 0.0;
  for (double y = 0.5 * step_m; y < size_m; y += step_m)
    for (double x = 0.5 * step_m; x < size_m; x += step_m)
      area += water.share({x, y}, step_m) * step_m * step_m;
  return area;
}

TEST(Water, IsAsLargeAsItsCells) {
  const Water water(round_lake(), 5);
  EXPECT_NEAR(area_m2(water, 10.0), std::numbers::pi * radius_m * radius_m, 0.02 * 1.13e6);
}

TEST(Water, IsAsLargeBySteps) {
  const Water water(round_lake(), 5);
  const double fine = area_m2(water, 5.0);
  EXPECT_NEAR(area_m2(water, 40.0), fine, 0.01 * fine);
}

// Stairs of cells would leave the circle by half a cell of 30 m; bays go a little farther.
TEST(Water, HasAShoreWithoutCorners) {
  const Water water(round_lake(), 5);
  int rises = 0;
  double least_m = 1e9, most_m = 0.0;
  for (int degree = 0; degree < 360; ++degree) {
    const glm::dvec2 out(std::cos(degree * 0.0174533), std::sin(degree * 0.0174533));
    double shore_m = radius_m - 60.0;
    while (water.share(middle_m + shore_m * out, 0.1) > 0.5) shore_m += 0.2;
    least_m = std::min(least_m, shore_m);
    most_m = std::max(most_m, shore_m);
    rises += water.share(middle_m + (shore_m + 2.0) * out, 0.1) < 0.5 ? 1 : 0;
  }
  EXPECT_GT(least_m, radius_m - 25.0);
  EXPECT_LT(most_m, radius_m + 25.0);
  EXPECT_GT(most_m - least_m, 5.0);
  EXPECT_GT(rises, 300);  // a shore, not a scatter of puddles
}

// Where cells end in a straight line, at 1492.5 m, the shore swings about it by some metres.
TEST(Water, HasBaysAlongAStraightShore) {
  Lakes lakes{GroundMap<int>(201, size_m, -1), {level_m}};
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 100; ++i) lakes.number.at(i, j) = 0;
  const Water water(lakes, 5);
  double mean_m = 0.0, square_m2 = 0.0;
  constexpr int rows = 700;
  for (int row = 0; row < rows; ++row) {
    double east_m = 1440.0;
    while (water.share({east_m, 200.0 + 3.0 * row}, 0.1) > 0.5) east_m += 0.1;
    mean_m += east_m / rows;
    square_m2 += east_m * east_m / rows;
  }
  EXPECT_NEAR(mean_m, 1492.5, 1.0);
  EXPECT_GT(std::sqrt(square_m2 - mean_m * mean_m), 1.0);
}

TEST(Water, IsLevelAndTheLandComesDownToIt) {
  const Water water(round_lake(), 5);
  Heightfield heights_m(301, size_m);
  for (int j = 0; j < 301; ++j)
    for (int i = 0; i < 301; ++i) {
      const double away_m = glm::length(heights_m.place_m(i, j) - middle_m);
      heights_m.at(i, j) = static_cast<float>(level_m + 0.1 * (away_m - radius_m));
    }
  const Heightfield before_m = heights_m;
  water.settle(heights_m);
  for (int j = 0; j < 301; ++j)
    for (int i = 0; i < 301; ++i) {
      const double away_m = glm::length(heights_m.place_m(i, j) - middle_m);
      if (away_m > radius_m + 60.0) {
        EXPECT_EQ(heights_m.at(i, j), before_m.at(i, j));
      }
      if (away_m < radius_m - 60.0 || water.share(heights_m.place_m(i, j), 0.1) >= 1.0) {
        EXPECT_EQ(heights_m.at(i, j), static_cast<float>(level_m));
      }
    }
}

}  // namespace
}  // namespace wold::terrain
