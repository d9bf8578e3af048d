#include "preview/relief_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold::preview {
namespace {

/// A cone in the middle of a square of 10 km.
Heightfield cone(float summit_m) {
  Heightfield terrain(201, 10000.0);
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 201; ++i)
      terrain.at(i, j) =
          summit_m * std::max(0.0F, 1.0F - std::hypot(i - 100.0F, j - 100.0F) / 90.0F);
  return terrain;
}

const landscape::Camera in_the_south{{5000.0, 1000.0, 100.0}, {5000.0, 5000.0, 100.0}, 50.0};

double brightness(const Image& picture, int x, int y) {
  const float* pixel = picture.pixel(x, y);
  return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

TEST(ReliefMap, IsLitFromTheNorthWest) {
  const Image map = relief_map(cone(1000.0F), in_the_south, {}, 200, {});
  const auto mean_about = [&](int x, int y) {
    double sum = 0.0;
    for (int j = -5; j <= 5; ++j)
      for (int i = -5; i <= 5; ++i) sum += brightness(map, x + i, y + j);
    return sum / 121.0;
  };
  EXPECT_GT(mean_about(70, 70), 1.3 * mean_about(130, 130));
  EXPECT_NEAR(mean_about(70, 130), mean_about(130, 70), 0.05);
}

TEST(ReliefMap, ShowsWhereTheCameraStands) {
  const Image map = relief_map(Heightfield(17, 10000.0), in_the_south, {}, 200, {});
  const float* eye = map.pixel(100, 180);  // a tenth of the way from the southern border
  EXPECT_GT(eye[0], eye[1] + 0.3F);
  EXPECT_LT(std::abs(map.pixel(100, 40)[0] - map.pixel(30, 40)[0]), 1e-6F);
}

TEST(ReliefMap, ShowsPaths) {
  const Image map = relief_map(Heightfield(17, 10000.0), in_the_south,
                               {{{2000.0, 8000.0}, {4000.0, 8000.0}}}, 200, {});
  const auto differs = [&](int x, int y) {
    return std::abs(map.pixel(x, y)[1] - map.pixel(30, 30)[1]) > 0.2F;
  };
  EXPECT_TRUE(differs(60, 40));
  EXPECT_FALSE(differs(60, 50));
  EXPECT_FALSE(differs(100, 40));
}

// Round numbers, so many that the relief can be read.
TEST(ReliefMap, HasContourLinesOfARoundInterval) {
  EXPECT_EQ(contour_interval_m(cone(1000.0F)), 100.0);
  EXPECT_EQ(contour_interval_m(cone(1700.0F)), 200.0);
  EXPECT_EQ(contour_interval_m(cone(42.0F)), 5.0);
  EXPECT_EQ(contour_interval_m(cone(0.4F)), 0.05);
  EXPECT_EQ(contour_interval_m(Heightfield(17, 10.0, 3.0F)), 0.0);
}

}  // namespace
}  // namespace wold::preview
