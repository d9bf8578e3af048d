#include "core/filled_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/coarser_parts.h"

namespace wold {
namespace {

TEST(FilledUp, HasTheFineValuesThatCountAndTheCoarseOnesElsewhere) {
  const Square square{{10.0, 20.0}, 8.0};
  const auto plane = [](const glm::dvec2& at_m) { return static_cast<float>(at_m.x + at_m.y); };
  const auto coarse = filled<FactorMap>({square, 3}, plane);
  const FactorMap fine(9, square, -1.0F);
  RowParts parts(9);
  parts[4] = {{2, 3}, {5, 8}};
  const FactorMap all = filled_up(fine, parts, coarse);
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) {
      const bool counts = j == 4 && (i == 2 || i >= 5) && i < 8;
      EXPECT_FLOAT_EQ(all.at(i, j), counts ? -1.0F : plane(all.place_m(i, j))) << i << ' ' << j;
    }
}

// Eleven steps of the fine grid are four of the coarse one: each fine sample lies between two
// coarse ones that count, and `steps` - 1 more beside them do.
TEST(CoarserParts, HoldWhatFineSamplesLieBetween) {
  const Square square{{0.0, 0.0}, 88.0};
  const GroundGrid fine{square, 89}, coarse{square, 33};
  RowParts parts(89);
  parts[44] = {{11, 12}, {40, 52}};
  parts[88] = {{88, 89}};
  for (const int steps : {1, 3}) {
    const RowParts found = coarser_parts(fine, parts, coarse, steps);
    ASSERT_EQ(found.size(), 33U);
    for (int j = 0; j < 33; ++j) {
      std::vector<int> counted;
      visit_row(found[static_cast<std::size_t>(j)], [&](int i) { counted.push_back(i); });
      for (int i = 0; i < 33; ++i) {
        const auto near = [&](double at, double first, double last) {
          return at > first - steps && at < last + steps;
        };
        const bool counts =
            (near(j, 16.0, 16.0) && (near(i, 4.0, 4.0) || near(i, 40 / 2.75, 51 / 2.75))) ||
            (near(j, 32.0, 32.0) && near(i, 32.0, 32.0));
        EXPECT_EQ(std::ranges::count(counted, i), counts ? 1 : 0) << i << ' ' << j << ' ' << steps;
      }
    }
  }
}

TEST(Lattice, HoldsWhatACoarserMapTakes) {
  const Square square{{0.0, 0.0}, 10.0};
  const GroundGrid fine{square, 11}, coarse{square, 4};
  const auto plane = filled<FactorMap>(
      fine, [](const glm::dvec2& at_m) { return static_cast<float>(at_m.x + 100.0 * at_m.y); });
  const std::vector<int> taken = {0, 3, 7, 10};
  const RowParts parts = lattice(fine, coarse);
  for (int j = 0; j < 11; ++j) {
    std::vector<int> counted;
    visit_row(parts[static_cast<std::size_t>(j)], [&](int i) { counted.push_back(i); });
    EXPECT_EQ(counted, std::ranges::count(taken, j) > 0 ? taken : std::vector<int>{}) << j;
  }
  EXPECT_FLOAT_EQ(on_lattice(plane, coarse).at(2, 1), 7.0F + 300.0F);
}

TEST(CoarserParts, AreTheSameOnTheSameGrid) {
  const GroundGrid grid{{{0.0, 0.0}, 7.0}, 8};
  RowParts parts(8);
  parts[3] = {{0, 2}, {5, 8}};
  const RowParts found = coarser_parts(grid, parts, grid, /*steps=*/1);
  for (std::size_t j = 0; j < 8; ++j) {
    std::vector<int> want, got;
    visit_row(parts[j], [&](int i) { want.push_back(i); });
    visit_row(found[j], [&](int i) { got.push_back(i); });
    EXPECT_EQ(got, want) << j;
  }
}

}  // namespace
}  // namespace wold
