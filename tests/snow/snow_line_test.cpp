#include "snow/snow_line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/statistics.h"

namespace wold::snow {
namespace {

/// A plain with a trough of 40 m along its middle.
Heightfield troughed() {
  Heightfield terrain(201, 2000.0);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) = 20.0F - 20.0F * static_cast<float>(std::exp(-0.1 * (i - 100) * (i - 100)));
  return terrain;
}

FactorMap white(const SnowLine& line, const Square& square, int samples, float fraction) {
  return line.white_map(FactorMap(samples, square, fraction));
}

/// Changes between white and bare along rows.
int borders(const FactorMap& map) {
  int count = 0;
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 1; i < map.samples(); ++i)
      count += (map.at(i, j) > 0.5F) != (map.at(i - 1, j) > 0.5F) ? 1 : 0;
  return count;
}

TEST(SnowLine, CoversTheShareOnFineAndCoarseMaps) {
  const SnowLine line(Heightfield(2, 2000.0), 0.35, 7);
  for (const int samples : {101, 801})
    for (const float fraction : {0.0F, 0.1F, 0.5F, 0.8F, 1.0F})
      EXPECT_NEAR(mean(white(line, {{0.0, 0.0}, 2000.0}, samples, fraction).values()), fraction,
                  0.03)
          << samples;
}

// What a fine map shows of a patch of ground is on the mean what a coarse one shows of it.
TEST(SnowLine, IsTheSameForMapsOfAllSteps) {
  const SnowLine line(Heightfield(2, 2000.0), 0.35, 7);
  const FactorMap coarse = white(line, {{0.0, 0.0}, 1000.0}, 201, 0.5F);   // 5 m
  const FactorMap fine = white(line, {{200.0, 200.0}, 200.0}, 401, 0.5F);  // 0.5 m
  double between = 0.0, of_coarse = 0.0;
  for (int j = 42; j < 78; j += 2)
    for (int i = 42; i < 78; i += 2) {
      const glm::dvec2 at_m(5.0 * i, 5.0 * j);
      double block = 0.0;
      for (double y = -2.25; y < 2.5; y += 0.5)
        for (double x = -2.25; x < 2.5; x += 0.5)
          block += double{fine.sample(at_m.x + x, at_m.y + y)} / 100.0;
      between += (block - 0.5) * (double{coarse.at(i, j)} - 0.5);
      of_coarse += (double{coarse.at(i, j)} - 0.5) * (double{coarse.at(i, j)} - 0.5);
    }
  EXPECT_NEAR(between / of_coarse, 1.0, 0.2);
}

// At all steps there are patches of a few steps: smooth noise would have a tenth of the borders.
TEST(SnowLine, IsRaggedAtAllSteps) {
  const SnowLine line(Heightfield(2, 2000.0), 0.35, 7);
  for (const double size_m : {1500.0, 400.0, 60.0}) {
    const FactorMap map = white(line, {{100.0, 100.0}, size_m}, 401, 0.5F);
    EXPECT_GT(borders(map), 401 * 401 / 25) << size_m;
  }
}

TEST(SnowLine, LiesLowerInHollows) {
  const SnowLine line(troughed(), 0.35, 7);
  double trough = 0.0, plain = 0.0;
  for (int k = 0; k < 40; ++k) {
    const Square in{{990.0, 25.0 + 45.0 * k}, 20.0}, beside{{400.0, 25.0 + 45.0 * k}, 20.0};
    trough += mean(white(line, in, 21, 0.4F).values()) / 40.0;
    plain += mean(white(line, beside, 21, 0.4F).values()) / 40.0;
  }
  EXPECT_GT(trough, plain + 0.2);
}

}  // namespace
}  // namespace wold::snow
