#include "terrain/mountain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace wold::terrain {
namespace {

scene::Terrain alpine(int samples = 161) {
  scene::Terrain shape;
  shape.size_m = 240.0;
  shape.samples = samples;
  shape.hill_height_m = 84.0;
  shape.relief_m = 0.8;
  shape.relief_feature_m = 30.0;
  shape.talus_deg = 60.0;
  return shape;
}

double mean(const Heightfield& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0) /
         static_cast<double>(map.values().size());
}

double highest_border(const Heightfield& map) {
  const int last = map.samples() - 1;
  float highest_m = 0.0F;
  for (int k = 0; k <= last; ++k)
    highest_m = std::max({highest_m, map.at(k, 0), map.at(k, last), map.at(0, k), map.at(last, k)});
  return highest_m;
}

TEST(Mountain, StandsWhereAndAsHighAsItShould) {
  const scene::Terrain shape = alpine();
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const Heightfield ground = make_mountain(shape, seed);
    const auto top = std::ranges::max_element(ground.values());
    const auto place = static_cast<int>(top - ground.values().begin());
    EXPECT_NEAR(*top, shape.hill_height_m, 0.03 * shape.hill_height_m);
    EXPECT_NEAR(place % shape.samples / (shape.samples - 1.0), 0.52, 0.02) << "seed " << seed;
    EXPECT_NEAR(place / shape.samples / (shape.samples - 1.0), 0.62, 0.02) << "seed " << seed;
    EXPECT_LT(highest_border(ground), 0.12 * shape.hill_height_m) << "seed " << seed;
    // What streams take from the valleys lifts the crests: a sixth of the box about it is mountain.
    EXPECT_NEAR(mean(ground), 0.17 * shape.hill_height_m, 0.017 * shape.hill_height_m)
        << "seed " << seed;
  }
}

TEST(Mountain, StandsInFullViewOfItsMeadow) {
  const scene::Terrain shape = alpine();
  const Heightfield ground = make_mountain(shape, 1);
  const double eye_m = ground.sample(0.5 * shape.size_m, 0.05 * shape.size_m) + 1.7;
  for (double v = 0.0; v < 0.14; v += 0.02)
    for (double u = 0.1; u < 0.9; u += 0.05)
      EXPECT_LT(ground.sample(u * shape.size_m, v * shape.size_m), 0.1 * shape.hill_height_m);
  double highest_deg = 0.0;
  for (double v = 0.06; v < 1.0; v += 0.005) {
    const double rise_m = ground.sample(0.5 * shape.size_m, v * shape.size_m) - eye_m;
    highest_deg =
        std::max(highest_deg, glm::degrees(std::atan2(rise_m, (v - 0.05) * shape.size_m)));
  }
  EXPECT_GT(highest_deg, 20.0);
}

/// Crests on a ring around the summit, and the 9th decile of its heights against the 1st.
TEST(Mountain, HasRidgesAndValleysAllAround) {
  const scene::Terrain shape = alpine();
  const Heightfield ground = make_mountain(shape, 2);
  std::vector<double> ring_m;
  for (int k = 0; k < 360; ++k) {
    const double bearing = glm::radians(static_cast<double>(k));
    ring_m.push_back(ground.sample((0.52 + 0.22 * std::sin(bearing)) * shape.size_m,
                                   (0.62 + 0.22 * std::cos(bearing)) * shape.size_m));
  }
  int crests = 0;
  for (std::size_t k = 0; k < 360; ++k) {
    double highest_m = 0.0;
    for (std::size_t near = 350; near <= 370; ++near)
      highest_m = std::max(highest_m, ring_m[(k + near) % 360]);
    if (ring_m[k] == highest_m) ++crests;
  }
  EXPECT_GE(crests, 5);
  std::ranges::sort(ring_m);
  EXPECT_GT(ring_m[324] - ring_m[36], 0.15 * shape.hill_height_m);
}

/// Heights over the mean of a ring about them, root mean square, where the mountain is high.
double relief_m(const Heightfield& ground, double radius_m, double lowest_m) {
  double sum_m2 = 0.0;
  int count = 0;
  for (double y = 0.2 * ground.size_m(); y < 0.9 * ground.size_m(); y += 1.0)
    for (double x = 0.1 * ground.size_m(); x < 0.9 * ground.size_m(); x += 1.0) {
      const double height_m = ground.sample(x, y);
      if (height_m < lowest_m) continue;
      double ring_m = 0.0;
      for (int k = 0; k < 16; ++k) {
        const double bearing = glm::radians(22.5 * k);
        ring_m += ground.sample(x + radius_m * std::sin(bearing), y + radius_m * std::cos(bearing));
      }
      sum_m2 += (height_m - ring_m / 16.0) * (height_m - ring_m / 16.0);
      ++count;
    }
  return std::sqrt(sum_m2 / count);
}

// Cut by the coarsest streams alone, whose valleys lie farther apart, spurs are round knolls: 0.040
// to 0.045 of the mountain's height.
TEST(Mountain, SpursStandOutBetweenSmallValleys) {
  scene::Terrain shape = alpine(301);
  shape.relief_m = 0.0;
  for (const std::uint64_t seed : {1U, 2U})
    EXPECT_GT(relief_m(make_mountain(shape, seed), 0.04 * shape.size_m, 0.15 * shape.hill_height_m),
              0.05 * shape.hill_height_m)
        << "seed " << seed;
}

TEST(Mountain, IsTheSameWithMoreSamplesAndAnotherWithAnotherSeed) {
  const Heightfield coarse = make_mountain(alpine(151), 1);
  const Heightfield fine = make_mountain(alpine(301), 1);
  const Heightfield other = make_mountain(alpine(151), 2);
  EXPECT_NEAR(mean(fine) / mean(coarse), 1.0, 0.05);
  const auto apart_m = [&](const Heightfield& map) {
    double sum_m = 0.0;
    for (double y = 0.0; y < 240.0; y += 4.0)
      for (double x = 0.0; x < 240.0; x += 4.0)
        sum_m += std::abs(map.sample(x, y) - coarse.sample(x, y)) / 3600.0;
    return sum_m;
  };
  EXPECT_LT(apart_m(fine), 0.03 * 84.0);
  EXPECT_GT(apart_m(other), 3.0 * apart_m(fine));
}

/// How far samples are from the mean of what lies about them on a finer map, root mean square.
double off_the_mean_m(const Heightfield& few, const Heightfield& many) {
  double sum_m2 = 0.0;
  int count = 0;
  const double step_m = few.size_m() / (few.samples() - 1.0);
  for (int j = 1; j < few.samples() - 1; ++j)
    for (int i = 1; i < few.samples() - 1; ++i, ++count) {
      double about_m = 0.0;
      for (int k = 0; k < 49; ++k)
        about_m += many.sample((i + (k % 7 - 3) / 7.0) * step_m, (j + (k / 7 - 3) / 7.0) * step_m);
      sum_m2 += std::pow(few.at(i, j) - about_m / 49.0, 2);
    }
  return std::sqrt(sum_m2 / count);
}

// Crests and ravines that 33 samples cannot have would be met by chance: 1.39 m.
TEST(Mountain, FewSamplesAreOfWhatLiesAboutThem) {
  scene::Terrain few = alpine(33), many = alpine(301);
  few.relief_m = many.relief_m = 0.0;
  few.streams = many.streams = 0.0;
  EXPECT_LT(off_the_mean_m(make_mountain(few, 1), make_mountain(many, 1)), 1.3);
}

TEST(Mountain, OfNoHeightIsLevel) {
  scene::Terrain level = alpine(33);
  level.hill_height_m = 0.0;
  level.relief_m = 0.0;
  const Heightfield ground = make_mountain(level, 1);
  for (const float height_m : ground.values()) EXPECT_EQ(height_m, 0.0F);
}

TEST(Mountain, IsTheSameOnAnyNumberOfThreads) {
  const auto heights_m = [](int threads) {
    const ThreadLimit limit(threads);
    return make_mountain(alpine(101), 1).values();
  };
  EXPECT_EQ(heights_m(1), heights_m(2));
}

}  // namespace
}  // namespace wold::terrain
