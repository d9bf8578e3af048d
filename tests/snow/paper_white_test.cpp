#include "snow/paper_white.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace wold::snow {
namespace {

double mean(const FactorMap& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0) /
         static_cast<double>(map.values().size());
}

/// A triangle of the ground, counter-clockwise, and how much of the texture it carries.
struct Facet {
  std::array<glm::dvec3, 3> corners_m;
  double texture_area;  ///< of the square of side 1 that the texture is
  double ground_m2() const {
    return 0.5 * glm::length(glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[1]));
  }
  double phi_per_m2() const { return texture_area / ground_m2(); }
};

/// A right triangle of that side, rising by `slope` to the north.
Facet facet(double side_m, double slope, double texture_area) {
  return {{{{0.0, 0.0, 0.0}, {side_m, 0.0, 0.0}, {side_m, side_m, slope * side_m}}}, texture_area};
}

/// The paper's steps for one facet: dots by number per m2 of ground fall on its texels at random;
/// the fraction of these that is white.
double white_fraction(const Facet& facet, double dots_per_m2, double texels_of_texture,
                      std::mt19937& random) {
  std::vector<char> texels(static_cast<std::size_t>(facet.texture_area * texels_of_texture));
  std::poisson_distribution<int> dots(dots_per_m2 * facet.ground_m2());
  std::uniform_int_distribution<std::size_t> anywhere(0, texels.size() - 1);
  for (int dot = dots(random); dot > 0; --dot) texels[anywhere(random)] = 1;
  return std::accumulate(texels.begin(), texels.end(), 0.0) / static_cast<double>(texels.size());
}

/// Small and large facets, level and steep, with much and little texture: gamma phi whitens all of
/// them as paper_white() does. Without phi the coarse ones would be white first.
TEST(PaperWhite, IsWhatThePapersNoiseMakesOfFacetsOfAnyPhi) {
  constexpr double texels = 2e5, four_per_texel = 4.0 * texels;
  std::mt19937 random(3);
  for (const double gamma : {0.075, 0.25, 0.6}) {
    const double expected = mean(paper_white(64.0, gamma, 1025, 5));
    EXPECT_NEAR(expected, 1.0 - std::exp(-4.0 * gamma), 2e-3);
    for (const Facet& one : {facet(40.0, 0.0, 0.1), facet(40.0, 1.7, 0.1), facet(40.0, 0.0, 0.4),
                             facet(3.0, 0.0, 0.1), facet(1.0, 0.5, 0.8)}) {
      const double noise = gamma * one.phi_per_m2() * four_per_texel;
      EXPECT_NEAR(white_fraction(one, noise, texels, random), expected, 0.015) << one.ground_m2();
    }
    const Facet fine = facet(3.0, 0.0, 0.4), coarse = facet(6.0, 0.0, 0.1);
    const double same_noise = gamma * fine.phi_per_m2() * four_per_texel;
    EXPECT_GT(white_fraction(coarse, same_noise, texels, random), expected + 0.08);
  }
}

TEST(PaperWhite, OnlyGrows) {
  EXPECT_EQ(mean(paper_white(64.0, 0.0, 129, 5)), 0.0);
  const FactorMap before = paper_white(64.0, 0.2, 129, 5);
  const FactorMap after = paper_white(64.0, 0.3, 129, 5);
  for (std::size_t i = 0; i < before.values().size(); ++i)
    ASSERT_LE(before.values()[i], after.values()[i]);
}

}  // namespace
}  // namespace wold::snow
