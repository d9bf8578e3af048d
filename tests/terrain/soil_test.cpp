#include "terrain/soil.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"

namespace wold::terrain {
namespace {

const glm::dvec3 flat(0.0, 0.0, 1.0);
const glm::dvec3 to_sun = glm::normalize(glm::dvec3(-0.6, -0.5, 0.6));

Soil soil_at(double step_m) {
  scene::Terrain terrain;
  terrain.size_m = 40.0;
  terrain.ground_albedo = {0.1, 0.08, 0.06};
  return {terrain, 5, step_m};
}

/// Green of places that lie `apart_m` apart, along rows of 200 m.
std::vector<double> green(const Soil& soil, double apart_m, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double way_m = apart_m * i;
    const glm::dvec2 at_m(std::fmod(way_m, 200.0), 7.3 * std::floor(way_m / 200.0));
    values.push_back(double{soil.at(at_m, flat, to_sun).g});
  }
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Root of half the mean square of neighbours' difference, over the mean.
double contrast_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) sum += std::pow(values[i] - values[i - 1], 2);
  return std::sqrt(0.5 * sum / static_cast<double>(values.size() - 1)) / mean_of(values);
}

TEST(Soil, HasItsAlbedoOnTheMeanHoweverFine) {
  for (const double step_m : {0.005, 0.02, 0.1, 0.5, 5.0})
    EXPECT_NEAR(mean_of(green(soil_at(step_m), 1.37, 60000)), 0.08, 0.0025) << step_m << " m";
}

// A centimetre away there is another crumb, another stone or another blade; a coarse map has none
// of them.
TEST(Soil, IsMadeOfCrumbsNearTheEye) {
  EXPECT_GT(contrast_of(green(soil_at(0.005), 0.01, 20000)), 0.1);
  EXPECT_LT(contrast_of(green(soil_at(0.7), 0.01, 20000)), 0.02);
}

// The sun lights the side of a clod that it stands over: along the sun's way brightness rises in
// front of a clod's middle as much as it falls behind, and the other sun has it the other way
// round.
TEST(Soil, TurnsWithTheSun) {
  const Soil soil = soil_at(0.005);
  const glm::dvec3 from_west = glm::normalize(glm::dvec3(-1.0, 0.0, 0.4));
  const glm::dvec3 from_east = glm::normalize(glm::dvec3(1.0, 0.0, 0.4));
  double alike = 0.0, west2 = 0.0, east2 = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const auto along = [i](const char* axis) {
      return 40.0 * random_uniform({3, 0, static_cast<std::uint64_t>(i), key_of(axis)});
    };
    const glm::dvec2 at_m(along("x"), along("y"));
    const double level{soil.at(at_m, flat, flat).g};
    const double west = double{soil.at(at_m, flat, from_west).g} / level - 1.0;
    const double east = double{soil.at(at_m, flat, from_east).g} / level - 1.0;
    alike += west * east, west2 += west * west, east2 += east * east;
  }
  EXPECT_LT(alike / std::sqrt(west2 * east2), -0.5);
}

/// Domes are bright on the side of the sun.
TEST(BrokenSurface, DomesFaceTheSunWhereTheyRise) {
  constexpr std::array<BlockSize, 1> domes{{{1.0, 0.0, 0.0, 0.0, 0.4}}};
  const BrokenSurface<2> surface(domes, 9, 0.01);
  const glm::dvec3 from_east = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 at_m(0.37 * i, 0.11 * i);
    const double east_of_middle = -block_at<2>(at_m, 9).middle_away.x;
    if (std::abs(east_of_middle) < 0.1) continue;
    EXPECT_EQ(surface.shade(at_m, flat, from_east) > 1.0, east_of_middle > 0.0) << i;
    ++seen;
  }
  EXPECT_GT(seen, 200);
}

}  // namespace
}  // namespace wold::terrain
