#include "terrain/streams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/noise.h"
#include "core/parallel.h"

namespace wold::terrain {
namespace {

/// Fractal ground full of pits over a dome, zero at the border; the same for any number of samples.
GroundMap<double> pitted_dome(int samples) {
  const Fbm relief(5, 5, 0.7);
  GroundMap<double> heights_m(samples, 100.0);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 at = glm::dvec2(i, j) / (samples - 1.0);
      const double dome = std::sin(std::numbers::pi * at.x) * std::sin(std::numbers::pi * at.y);
      heights_m.at(i, j) = dome * (20.0 + 8.0 * relief.at(at / 0.2));
    }
  return heights_m;
}

struct Down {
  int to = -1;  ///< the steepest neighbour's place; -1: none is lower
  double slope = 0.0;
};

Down steepest_down(const GroundMap<double>& map, int i, int j) {
  Down down;
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      const double run_m = std::hypot(di, dj) * map.step_m();
      const double drop_m = map.at(i, j) - map.at(i + di, j + dj);
      if (drop_m > down.slope * run_m) down = {(j + dj) * map.samples() + i + di, drop_m / run_m};
    }
  return down;
}

bool inside(const GroundMap<double>& map, int k) {
  const int i = k % map.samples();
  const int j = k / map.samples();
  return std::min(i, j) > 0 && std::max(i, j) < map.samples() - 1;
}

/// Where water goes from every sample; nothing for the border.
std::vector<Down> drainage(const GroundMap<double>& map) {
  std::vector<Down> downs(map.values().size());
  for (int j = 1; j + 1 < map.samples(); ++j)
    for (int i = 1; i + 1 < map.samples(); ++i)
      downs[static_cast<std::size_t>(j * map.samples() + i)] = steepest_down(map, i, j);
  return downs;
}

/// Samples that drain through each one.
std::vector<double> counts(const GroundMap<double>& map, const std::vector<Down>& downs) {
  std::vector<std::size_t> order(map.values().size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t k) { return map.values()[k]; });
  std::vector<double> result(order.size(), 1.0);
  for (const std::size_t k : order)
    if (downs[k].to >= 0) result[static_cast<std::size_t>(downs[k].to)] += result[k];
  return result;
}

double mean(const GroundMap<double>& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0) /
         static_cast<double>(map.values().size());
}

int pits(const GroundMap<double>& map) {
  const std::vector<Down> downs = drainage(map);
  int count = 0;
  for (int k = 0; k < static_cast<int>(downs.size()); ++k)
    if (inside(map, k) && downs[static_cast<std::size_t>(k)].to < 0) ++count;
  return count;
}

TEST(Streams, OneSampleAboveTheSeaDecaysExponentially) {
  // A quarter of the map drains over half a side: dz/dt = -K sqrt(1/4) z / (1/2).
  GroundMap<double> heights_m(3, 8.0);
  heights_m.at(1, 1) = 5.0;
  carve(heights_m, {.reach = 1.5, .steps = 4000});
  EXPECT_NEAR(heights_m.at(1, 1), 5.0 * std::exp(-1.5), 2e-3);
}

TEST(Streams, AreSteadyWhereSlopeFallsWithTheRootOfTheArea) {
  // Uplift U t and reach K t: S = U / (K sqrt(A)), with lengths in sides.
  GroundMap<double> heights_m = pitted_dome(65);
  const GroundMap<double> uplift_m(65, 100.0, 2000.0);
  carve(heights_m, uplift_m, {.reach = 200.0, .source_fraction = 1e-9, .steps = 400});
  const std::vector<Down> downs = drainage(heights_m);
  const std::vector<double> samples = counts(heights_m, downs);
  int inner = 0;
  int lawful = 0;
  for (std::size_t k = 0; k < downs.size(); ++k) {
    if (!inside(heights_m, static_cast<int>(k))) continue;
    const double expected = 2000.0 / (200.0 * 100.0 * std::sqrt(samples[k] / (64.0 * 64.0)));
    ++inner;
    if (std::abs(downs[k].slope / expected - 1.0) < 1e-3) ++lawful;
  }
  EXPECT_GT(lawful, 0.97 * inner);
}

TEST(Streams, LeaveNoPit) {
  GroundMap<double> heights_m = pitted_dome(129);
  ASSERT_GT(pits(heights_m), 20);
  carve(heights_m, {.reach = 0.01, .steps = 1});
  EXPECT_EQ(pits(heights_m), 0);
  carve(heights_m, {.reach = 2.0, .steps = 10});
  EXPECT_EQ(pits(heights_m), 0);
}

TEST(Streams, KeepTheBaseLevel) {
  GroundMap<double> heights_m(33, 10.0);
  for (int i = 0; i < 33; ++i) heights_m.at(i, 0) = heights_m.at(0, i) = 1.0 + i;
  const GroundMap<double> before = heights_m;
  carve(heights_m, GroundMap<double>(33, 10.0, 3.0), {.reach = 1.0});
  for (int i = 0; i < 33; ++i) {
    EXPECT_EQ(heights_m.at(i, 0), before.at(i, 0));
    EXPECT_EQ(heights_m.at(32, i), before.at(32, i));
  }
  EXPECT_EQ(pits(heights_m), 0);
}

TEST(Streams, CutTheSameOnAFinerGrid) {
  GroundMap<double> coarse = pitted_dome(101);
  GroundMap<double> fine = pitted_dome(201);
  const double before = mean(fine);
  carve(coarse, {.reach = 1.5, .source_fraction = 1e-3});
  carve(fine, {.reach = 1.5, .source_fraction = 1e-3});
  EXPECT_LT(mean(fine), 0.9 * before);
  EXPECT_NEAR(mean(fine) / mean(coarse), 1.0, 0.05);
}

TEST(Streams, AreTheSameOnAnyNumberOfThreads) {
  const auto carved = [](int threads) {
    const ThreadLimit limit(threads);
    GroundMap<double> heights_m = pitted_dome(129);
    carve(heights_m, {.reach = 1.0, .steps = 5});
    return heights_m.values();
  };
  EXPECT_EQ(carved(1), carved(2));
}

/// Fractal ground without borders, and where it stays: its lowest parts.
struct Tile {
  GroundMap<double> heights_m;
  BaseLevel lowlands;
};

/// Moved by that many samples.
Tile tile(int east, int north) {
  constexpr int side = 48;
  const Fbm relief(5, 4, 0.7, /*period=*/3);
  Tile tile{{side, 100.0}, {}};
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const glm::ivec2 at((i + east) % side, (j + north) % side);
      const double height = relief.at(3.0 / side * glm::dvec2(at));
      tile.heights_m.at(i, j) = 10.0 * height;
      tile.lowlands.push_back(height < -1.0);
    }
  return tile;
}

// A tile has no border: what streams make of it does not depend on where it begins.
TEST(Streams, FlowOverTheSidesOfATile) {
  const Incision incision{.reach = 1.0, .source_fraction = 1e-3, .steps = 4};
  Tile here = tile(0, 0), moved = tile(17, 31);
  const GroundMap<double> uplift_m(48, 100.0, 2.0);
  const GroundMap<double> before_m = here.heights_m;
  carve(here.heights_m, uplift_m, here.lowlands, incision);
  carve(moved.heights_m, uplift_m, moved.lowlands, incision);
  double changed_m = 0.0;
  for (int j = 0; j < 48; ++j)
    for (int i = 0; i < 48; ++i) {
      const int from_i = (i + 17) % 48, from_j = (j + 31) % 48;
      EXPECT_NEAR(moved.heights_m.at(i, j), here.heights_m.at(from_i, from_j), 1e-9)
          << i << " " << j;
      changed_m = std::max(changed_m, std::abs(here.heights_m.at(i, j) - before_m.at(i, j)));
    }
  EXPECT_GT(changed_m, 2.0);
}

TEST(Streams, LeaveTheBaseLevel) {
  Tile land = tile(0, 0);
  const GroundMap<double> before_m = land.heights_m;
  carve(land.heights_m, GroundMap<double>(48, 100.0, 2.0), land.lowlands, {});
  for (std::size_t k = 0; k < land.lowlands.size(); ++k) {
    if (!land.lowlands[k]) continue;
    EXPECT_EQ(land.heights_m.values()[k], before_m.values()[k]) << k;
  }
}

}  // namespace
}  // namespace wold::terrain
