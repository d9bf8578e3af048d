#include "cloud/sunlit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace wold::cloud {
namespace {

constexpr float top_m = 400.0F;
const Droplets droplets{.extinction_per_m = 0.05, .asymmetry = 0.85};

/// Bohren's two streams, and a fifth of what does not come through from the ground.
double bright(double optical_depth) {
  const double through = 1.0 / (1.0 + 0.75 * 0.15 * optical_depth);
  return through + 0.2 * (1.0 - through);
}

constexpr std::uint16_t highest = 65535, half_as_high = 32768;

/// Clouds in the columns before the one given, none behind.
LayerMap strip(int side, int cloudy_columns, std::uint16_t rank = highest) {
  LayerMap ranks(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < cloudy_columns; ++x) ranks.at(x, y) = rank;
  return ranks;
}

/// Brightness at a pixel's middle under a sun above.
double seen(const LayerMap& ranks, double pixel_m, int column) {
  const LayerMap lit =
      sunlit(ranks, {0.0F, 0.5F * top_m, top_m}, droplets, {0.0, 0.0, 1.0}, pixel_m);
  return lit.at(column, ranks.height() / 2) / 65535.0;
}

// Wherever light diffuses over so many pixels that coarser ones do, too.
TEST(Sunlit, OfAnEvenLayerIsThatOfItsDepth) {
  for (const double pixel_m : {50.0, 10.0, 2.0}) {
    EXPECT_NEAR(seen(strip(64, 64), pixel_m, 20), bright(20.0), 1e-3) << pixel_m;
    EXPECT_NEAR(seen(strip(64, 64, half_as_high), pixel_m, 20), bright(10.0), 1e-3) << pixel_m;
  }
}

// Light loses its direction over 1 / (extinction (1 - g)) = 133 m: so wide is the border between
// cloud and clear sky, half of it on either side. A triangle's weights make 20 m inside the edge
// 1 - (1 - 20 / 67)^2 / 2 of the cloud.
TEST(Sunlit, DiffusesOverTheTransportPath) {
  const double pixel_m = 5.0;
  const LayerMap ranks = strip(256, 128);
  const double half_m = 0.5 / (0.05 * 0.15);
  const auto column = [&](double inside_m) {
    return 127 - static_cast<int>(std::lround(inside_m / pixel_m - 0.5));
  };
  const double depth = 0.05 * double{top_m};
  EXPECT_NEAR(seen(ranks, pixel_m, column(half_m + 20.0)), bright(depth), 1e-3);
  EXPECT_NEAR(seen(ranks, pixel_m, column(-half_m - 20.0)), 1.0, 1e-3);
  const double fraction = 1.0 - 0.5 * std::pow(1.0 - 20.0 / half_m, 2);
  EXPECT_NEAR(seen(ranks, pixel_m, column(20.0)), bright(fraction * depth), 0.02);
  EXPECT_GT(seen(ranks, pixel_m, column(20.0)), bright(depth) + 0.025);
}

}  // namespace
}  // namespace wold::cloud
