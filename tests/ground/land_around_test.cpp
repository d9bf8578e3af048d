#include "ground/land_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/colour.h"

namespace wold::ground {
namespace {

/// Level land around a square of 64 m, half of whose places are bright, under clouds.
class LevelLand {
 public:
  static constexpr double spread = 0.2;

  explicit LevelLand(const Illuminate& illuminate =
                         [](const terrain::GroundLight& clear) { return clear.sun; })
      : around_{land_, day_, haze_, appearance(), illuminate, 7} {}

  /// Mean luminance of pixels of 50 m along a line to the north.
  double seen(const glm::dvec2& from_m, double length_m) const {
    constexpr int places = 40;
    double sum = 0.0;
    for (int i = 0; i < places; ++i)
      sum +=
          luminance(around_.near_radiance(from_m + glm::dvec2(0.0, length_m * i / places), 50.0));
    return sum / places;
  }

  /// Standard deviation of places' luminance over their mean, as pixels of that size see them.
  double deviation(double step_m) const {
    constexpr int side = 200;
    double sum = 0.0, squares = 0.0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double seen = luminance(around_.near_radiance({37.7 * i, 100.0 + 37.7 * j}, step_m));
        sum += seen;
        squares += seen * seen;
      }
    const double mean = sum / (side * side);
    return std::sqrt(std::max(0.0, squares / (side * side) - mean * mean)) / mean;
  }

 private:
  static scene::Terrain square() {
    scene::Terrain terrain;
    terrain.size_m = 64.0;
    terrain.samples = 17;
    return terrain;
  }
  static LandAppearance appearance() {
    std::vector<LandSample> samples;
    for (int i = 0; i < 400; ++i)
      samples.push_back({{0.0, 0.0, 1.0}, 0.0, glm::vec3(i % 2 == 0 ? 0.04F : 0.06F)});
    return LandAppearance(samples);
  }

  terrain::Surroundings land_{square(), Heightfield(17, 64.0), 1, 8000.0};
  light::Daylight day_{{45.0, 180.0}, {3.0}};
  Haze haze_{day_, {32.0, 32.0, 2.0}};
  LandAround around_;
};

// It has patches up to a kilometre, which differ as those do that the square has.
TEST(LandAround, DiffersMoreThanASmallSquare) {
  const LevelLand level;
  EXPECT_GT(level.deviation(0.25), 1.2 * LevelLand::spread);
  EXPECT_LT(level.deviation(0.25), 1.8 * LevelLand::spread);
}

// Else far land would flicker while the camera moves.
TEST(LandAround, IsEvenWithinAPixel) {
  const LevelLand level;
  EXPECT_LT(level.deviation(60.0), 0.85 * level.deviation(0.25));
  EXPECT_LT(level.deviation(1000.0), 0.4 * level.deviation(0.25));
  EXPECT_LT(level.deviation(4000.0), 1e-6);
}

// Clouds of 100 m, as far apart, darken stripes of the land.
TEST(LandAround, HasTheShadowsOfCloudsFarFromTheSquare) {
  const LevelLand land([](const terrain::GroundLight& clear) {
    ColourMap light = clear.sun;
    for (int j = 0; j < light.samples(); ++j)
      for (int i = 0; i < light.samples(); ++i)
        if (std::fmod(light.place_m(i, j).x + 1e6, 200.0) < 100.0) light.at(i, j) *= 0.1F;
    return light;
  });
  for (const double east_m : {200.0, -200.0, 600.0}) {
    const double shaded = land.seen({east_m + 50.0, -400.0}, 800.0);
    EXPECT_NEAR(shaded / land.seen({east_m + 150.0, -400.0}, 800.0), 0.1, 0.03) << east_m;
  }
}

}  // namespace
}  // namespace wold::ground
