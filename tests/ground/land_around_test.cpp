#include "ground/land_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/colour.h"

namespace wold::ground {
namespace {

/// Level land around a square of 64 m, half of whose places are bright.
class LevelLand {
 public:
  static constexpr double spread = 0.2;

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
  LandAround around_{
      land_, day_, haze_, appearance(), [](const terrain::GroundLight& clear) { return clear.sun; },
      7};
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

}  // namespace
}  // namespace wold::ground
