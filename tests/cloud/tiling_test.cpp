#include "cloud/tiling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/normal_distribution.h"

namespace wold::cloud {
namespace {

TextureSet cumulus(int side_px) {
  return textures_of(scene::CloudLayer{}, recipe_of(scene::CloudKind::cumulus), side_px, 3);
}

/// Kolmogorov and Smirnov's distance of a map's ranks from an even spread.
double distance_from_even(const LayerMap& map) {
  std::vector<std::uint16_t> sorted = map.values();
  std::ranges::sort(sorted);
  double distance = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    distance =
        std::max(distance, std::abs(sorted[i] / 65536.0 - static_cast<double>(i) / sorted.size()));
  return distance;
}

TEST(Tiling, WeightsSumToOneAndTheGridRepeats) {
  const glm::ivec2 cells(3, 5);
  const TriangleGrid grid(cells);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 place(i * 0.37 - 100.0, i * 0.21 - 70.0);
    const auto patches = grid.around(place);
    const auto again = grid.around(place + glm::dvec2(3.0, -10.0));
    double sum = 0.0;
    for (std::size_t p = 0; p < 3; ++p) {
      EXPECT_GE(patches[p].weight, 0.0);
      sum += patches[p].weight;
      const auto same = std::ranges::find(again, patches[p].vertex, &Patch::vertex);
      if (patches[p].weight < 1e-9) continue;  // rounding may name another vertex of no weight
      ASSERT_NE(same, again.end());
      EXPECT_NEAR(same->weight, patches[p].weight, 1e-9);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
  }
}

TEST(Tiling, WeightsAreContinuousAcrossTriangles) {
  const TriangleGrid grid({2, 2});
  const auto weight_of = [&](const glm::dvec2& place, const glm::ivec2& vertex) {
    double weight = 0.0;
    for (const Patch& patch : grid.around(place))
      if (patch.vertex == vertex) weight += patch.weight;
    return weight;
  };
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec2 place(i * 0.000577, i * 0.00113);
    for (const Patch& patch : grid.around(place))
      EXPECT_NEAR(weight_of(place + glm::dvec2(1e-6, -1e-6), patch.vertex), patch.weight, 1e-4);
  }
}

TEST(Tiling, BlendingKeepsHistogramAndVariance) {
  const TextureSet textures = cumulus(128);
  const LayerMap map = repeated_by_blending(textures, {10, 10}, {1280, 1280}, 7);
  EXPECT_LT(distance_from_even(map), 0.05);
  double sum = 0.0, squares = 0.0;
  for (const std::uint16_t rank : map.values()) {
    const double gaussian = normal_quantile((rank + 0.5) / 65536.0);
    sum += gaussian;
    squares += gaussian * gaussian;
  }
  const auto count = static_cast<double>(map.values().size());
  EXPECT_NEAR(sum / count, 0.0, 0.1);
  EXPECT_NEAR(squares / count, 1.0, 0.1);  // a linear blend would have about a half
}

/// Variance of the means of cells, of the Gaussianised ranks.
double variance_of_cells(const LayerMap& map, int cells) {
  const int side = map.width() / cells;
  double squares = 0.0;
  for (int cell = 0; cell < cells * cells; ++cell) {
    double sum = 0.0;
    for (int i = 0; i < side * side; ++i)
      sum += normal_quantile(
          (map.at(cell % cells * side + i % side, cell / cells * side + i / side) + 0.5) / 65536.0);
    squares += sum * sum / std::pow(side, 4);
  }
  return squares / (cells * cells);
}

// Patches wider than cells make these differ as wholes, and leave the cover of the layer.
TEST(Tiling, PatchesKeepTheHistogramAndAreLargerThanCells) {
  TextureSet textures = cumulus(32);
  const LayerMap without = repeated_by_blending(textures, {12, 12}, {384, 384}, 7);
  textures.patches = {.weight = 1.0, .cells = 3.0};
  const LayerMap with = repeated_by_blending(textures, {12, 12}, {384, 384}, 7);
  EXPECT_LT(distance_from_even(with), 0.05);
  EXPECT_GT(variance_of_cells(with, 12), variance_of_cells(without, 12) + 0.2);
  double across = 0.0, inside = 0.0;
  for (int i = 0; i < 384; ++i) {
    across += std::abs(with.at(0, i) - with.at(383, i)) + std::abs(with.at(i, 0) - with.at(i, 383));
    inside += std::abs(with.at(9, i) - with.at(8, i)) + std::abs(with.at(i, 9) - with.at(i, 8));
  }
  EXPECT_LT(across, 1.5 * inside);
}

TEST(Tiling, BlendingHasNoSeams) {
  const LayerMap map = repeated_by_blending(cumulus(64), {4, 4}, {256, 256}, 7);
  std::array<double, 4> steps{};  // mean step across cells' borders and inside, east and north
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) {
      const bool border = j % 64 == 0;
      const double fraction = border ? 1.0 / (4 * 256) : 1.0 / (252 * 256);
      steps[border ? 0 : 1] += fraction * std::abs(map.at(j, i) - map.wrapped(j - 1, i));
      steps[border ? 2 : 3] += fraction * std::abs(map.at(i, j) - map.wrapped(i, j - 1));
    }
  EXPECT_NEAR(steps[0] / steps[1], 1.0, 0.2);
  EXPECT_NEAR(steps[2] / steps[3], 1.0, 0.2);
}

TEST(Tiling, BlendedCellsAreAllDifferent) {
  const LayerMap map = repeated_by_blending(cumulus(32), {10, 10}, {320, 320}, 7);
  // Correlation of every pair of cells: a repetition would have 1.
  const auto cell_pixel = [&](int cell, int i) {
    return map.at(cell % 10 * 32 + i % 32, cell / 10 * 32 + i / 32) / 65536.0 - 0.5;
  };
  double max = 0.0;
  for (int a = 0; a < 100; ++a)
    for (int b = a + 1; b < 100; ++b) {
      double ab = 0.0, aa = 0.0, bb = 0.0;
      for (int i = 0; i < 1024; i += 3) {
        ab += cell_pixel(a, i) * cell_pixel(b, i);
        aa += cell_pixel(a, i) * cell_pixel(a, i);
        bb += cell_pixel(b, i) * cell_pixel(b, i);
      }
      max = std::max(max, ab / std::sqrt(aa * bb));
    }
  EXPECT_LT(max, 0.95);
}

TEST(Tiling, AsInThePaperShowsOneTextureInEachCell) {
  const TextureSet textures = cumulus(32);
  const LayerMap map = repeated_as_paper(textures, {6, 3}, {192, 96}, 7);
  std::array<int, 3> used{};
  for (int cell = 0; cell < 18; ++cell) {
    int shown = -1;
    for (int t = 0; t < 3; ++t) {
      bool same = true;
      for (int i = 0; i < 1024; ++i)
        same = same && map.at(cell % 6 * 32 + i % 32, cell / 6 * 32 + i / 32) ==
                           static_cast<std::uint16_t>(65536.0F *
                                                      textures.ranks[static_cast<std::size_t>(t)]
                                                          .values()[static_cast<std::size_t>(i)]);
      if (same) shown = t;
    }
    ASSERT_GE(shown, 0) << cell;
    ++used[static_cast<std::size_t>(shown)];
  }
  for (const int cells : used) EXPECT_GT(cells, 0);
}

}  // namespace
}  // namespace wold::cloud
