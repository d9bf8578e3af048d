#include "cloud/box_filter.h"

#include <gtest/gtest.h>

#include <array>

#include "core/random.h"

namespace wold::cloud {
namespace {

PeriodicMap<float> random_map(int width, int height) {
  PeriodicMap<float> map(width, height);
  for (std::size_t i = 0; i < map.values().size(); ++i)
    map.values()[i] = static_cast<float>(random_uniform({3, key_of("map"), i, 0}));
  return map;
}

/// Added up anew for every pixel.
double mean_about(const PeriodicMap<float>& map, int x, int y, int radius) {
  double sum = 0.0;
  for (int j = y - radius; j <= y + radius; ++j)
    for (int i = x - radius; i <= x + radius; ++i) sum += double{map.wrapped(i, j)};
  return sum / ((2 * radius + 1) * (2 * radius + 1));
}

// Also where the square is as wide as the map, and with maps wider than the strips that are
// filtered at once.
TEST(BoxFilter, IsTheMeanOfEachPixelsSquare) {
  for (const auto& [width, height, radius] : {std::array{23, 17, 1}, std::array{23, 17, 5},
                                              std::array{9, 31, 4}, std::array{300, 5, 2}}) {
    const PeriodicMap<float> map = random_map(width, height);
    const PeriodicMap<float> filtered = box_filtered(map, radius);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        ASSERT_NEAR(filtered.at(x, y), mean_about(map, x, y, radius), 1e-6)
            << x << ' ' << y << " of " << width << " x " << height;
  }
}

TEST(BoxFilter, OfNoRadiusChangesNothing) {
  const PeriodicMap<float> map = random_map(7, 5);
  EXPECT_EQ(box_filtered(map, 0).values(), map.values());
}

TEST(BoxFilter, HalvesAreMeansOfFour) {
  const PeriodicMap<float> map = random_map(48, 32);
  const std::vector<PeriodicMap<float>> halves = with_halves(map);
  ASSERT_EQ(halves.size(), 3U);  // 8 rows are few
  EXPECT_EQ(halves[0].values(), map.values());
  EXPECT_EQ(halves[2].width(), 12);
  for (const auto& [x, y] : {std::array{0, 0}, std::array{11, 7}, std::array{5, 3}}) {
    double sum = 0.0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) sum += double{map.at(4 * x + i, 4 * y + j)};
    EXPECT_NEAR(halves[2].at(x, y), sum / 16.0, 1e-6);
  }
  EXPECT_EQ(with_halves(random_map(31, 32)).size(), 1U);
}

}  // namespace
}  // namespace wold::cloud
