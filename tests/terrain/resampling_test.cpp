#include "terrain/resampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "terrain/cell_map.h"

namespace wold::terrain {
namespace {

/// value(x, y) at the middles of 12 x 12 cells from (5, 7) on.
template <class Value>
CellBlock block_of(const Value& value) {
  CellBlock block{{5, 7}, {12, 12}, {}};
  for (int row = 7; row < 19; ++row)
    for (int column = 5; column < 17; ++column)
      block.values.push_back(value(column + 0.5, row + 0.5));
  return block;
}

// Keys's kernel is exact for polynomials of the second degree.
TEST(Resampling, CubicConvolutionKeepsParabolas) {
  const auto parabola = [](double x, double y) { return 3.0 + x * y - 0.5 * x * x + 2.0 * y * y; };
  const CellBlock block = block_of(parabola);
  for (double y = 9.0; y < 16.0; y += 0.37)
    for (double x = 7.0; x < 14.0; x += 0.41)
      EXPECT_NEAR(cubic_value(block, {x, y}), parabola(x, y), 1e-10) << x << " " << y;
}

TEST(Resampling, ThereIsNothingInVoidsAndBeyond) {
  CellBlock block = block_of([](double x, double) { return x; });
  block.values[5 * 12 + 5] = std::numeric_limits<double>::quiet_NaN();  // cell (10, 12)
  EXPECT_TRUE(std::isnan(cubic_value(block, {10.5, 12.5})));
  EXPECT_NEAR(cubic_value(block, {9.9, 14.2}), 9.9, 1e-12);   // beside it
  EXPECT_NEAR(cubic_value(block, {11.1, 12.5}), 11.5, 0.41);  // what is left of two cells is one
  EXPECT_TRUE(std::isnan(cubic_value(block, {4.9, 12.5})));
  EXPECT_TRUE(std::isnan(cubic_value(block, {std::nan(""), 12.5})));
  EXPECT_TRUE(std::isnan(mean_value(block, {10.1, 12.1}, {10.9, 12.9})));
  EXPECT_TRUE(std::isnan(mean_value(block, {20.0, 12.1}, {21.0, 12.9})));
}

TEST(Resampling, AMeanCountsEachCellByItsShare) {
  const CellBlock block = block_of([](double x, double y) { return x + 10.0 * y; });
  // Of a linear function of whole cells, the value in the middle.
  EXPECT_NEAR(mean_value(block, {6.0, 9.0}, {10.0, 12.0}), 8.0 + 105.0, 1e-12);
  // A quarter of cell 6 and all of cell 7.
  EXPECT_NEAR(mean_value(block, {6.75, 9.0}, {8.0, 10.0}), (0.25 * 6.5 + 7.5) / 1.25 + 95.0, 1e-12);
  // What lies beyond does not count.
  EXPECT_NEAR(mean_value(block, {0.0, 0.0}, {6.0, 8.0}), 5.5 + 75.0, 1e-12);
}

/// As a projection curves a square of 100 km: to some millionths.
glm::dvec2 curved(const glm::dvec2& m) {
  const double bend = m.x * m.y / 6.4e6;
  return {1000.3 + (0.9 * m.x + 0.1 * m.y + bend) / 90.0,
          700.7 + (0.1 * m.x - 0.9 * m.y - m.x * m.x / 6.4e6) / 90.0};
}

// Means over a cell of what lies between cells are the cell's own, but for what is finest.
TEST(Resampling, KeepsTheMeansOfCells) {
  CellBlock means{{0, 0}, {40, 40}, {}};
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column)
      means.values.push_back(std::sin(0.9 * column) * std::cos(1.1 * row));
  const CellBlock sharp = with_means_kept(means);
  const auto mean = [](const CellBlock& block) {
    constexpr int parts = 8;
    double sum = 0.0;
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i < parts; ++i)
        sum +=
            cubic_value(block, glm::dvec2(20.0, 17.0) + (glm::dvec2(i, j) + 0.5) / (1.0 * parts));
    return sum / (parts * parts);
  };
  EXPECT_NEAR(mean(sharp), means.at({20, 17}), 0.005);
  EXPECT_GT(std::abs(mean(means) - means.at({20, 17})), 0.02);
}

// Half steps begin half a step before the first sample.
TEST(CellMap, FollowsTheProjection) {
  constexpr int samples = 33;
  constexpr double size_m = 1e5;
  const CellMap map([](const glm::dvec2& m) { return std::optional(curved(m)); }, samples, size_m);
  for (int j = 0; j <= 2 * samples; j += 3)
    for (int i = 0; i <= 2 * samples; i += 5) {
      const glm::dvec2 fraction = (0.5 * glm::dvec2(i, j) - 0.5) / (samples - 1.0);
      const glm::dvec2 off = map.at(i, j) - curved((fraction - 0.5) * size_m);
      EXPECT_LT(glm::length(off), 5e-4) << i << " " << j;
    }
}

TEST(CellMap, DoesNotSeeTheLastBitsOfTheProjection) {
  const auto with_noise = [](double noise) {
    return CellMap(
        [noise](const glm::dvec2& m) { return std::optional(curved(m) * (1.0 + noise)); }, 17, 5e3);
  };
  const CellMap here = with_noise(0.0);
  const CellMap there = with_noise(4e-15);
  for (int j = 0; j <= 34; ++j)
    for (int i = 0; i <= 34; ++i) EXPECT_EQ(here.at(i, j), there.at(i, j));
}

// Beyond a meridian degrees start anew.
TEST(CellMap, AsksForEachPlaceWhereTheProjectionLeaps) {
  const auto leaping = [](const glm::dvec2& m) -> std::optional<glm::dvec2> {
    if (m.y > 900.0) return std::nullopt;
    return curved(m) + (m.x > 333.0 ? glm::dvec2(3600.0, 0.0) : glm::dvec2(0.0));
  };
  const CellMap map(leaping, 21, 2000.0);
  EXPECT_EQ(map.at(20, 11), *leaping({-50.0, -500.0}));
  EXPECT_EQ(map.at(31, 11), *leaping({500.0, -500.0}));
  EXPECT_TRUE(std::isnan(map.at(20, 41).x));
}

}  // namespace
}  // namespace wold::terrain
