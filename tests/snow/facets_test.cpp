#include "snow/facets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace wold::snow {
namespace {

Facet facet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return {{a, b, c}, 0.25};
}

/// Level to the west, 60 degrees steep to the east.
Heightfield edge() {
  Heightfield terrain(65, 64.0);
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      terrain.at(i, j) = static_cast<float>(std::max(i - 32, 0) * std::sqrt(3.0));
  return terrain;
}

TEST(Facet, HasTheAngleOfTheCrossProductOfItsEdges) {
  EXPECT_NEAR(angle_deg(facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), 0.0, 1e-9);
  EXPECT_NEAR(angle_deg(facet({0, 0, 0}, {1, 0, 0}, {0, 1, 1})), 45.0, 1e-9);
  EXPECT_NEAR(angle_deg(facet({0, 0, 0}, {1, 0, 0}, {0, 0, 1})), 90.0, 1e-9);
  EXPECT_NEAR(angle_deg(facet({0, 0, 0}, {0, 1, 0}, {1, 0, 0})), 180.0, 1e-9);
}

TEST(Facet, TakesNoiseByItsTextureUnlessItHangsOverOrHasNoArea) {
  const Facet level = facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(noise_per_m2(level, 0.4), 0.4 * 0.25 / 0.5, 1e-12);
  EXPECT_EQ(noise_per_m2(facet({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), 0.4), 0.0);
  const Facet line = facet({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(angle_deg(line), 0.0);
  EXPECT_EQ(texture_per_m2(line), 0.0);
  EXPECT_EQ(noise_per_m2(line, 0.4), 0.0);
}

TEST(Facets, HaveTheMeanAreaThatWasAskedFor) {
  EXPECT_EQ(Facets(Heightfield(65, 400.0), 800.0).along_side(), 10);
  EXPECT_EQ(Facets(Heightfield(65, 4.0), 800.0).along_side(), 1);
  EXPECT_EQ(Facets(Heightfield(2, 4.0), 1e-4).along_side(), 1);
  const Facets facets(edge(), 32.0);
  EXPECT_NEAR(texture_per_m2(facets.at(1, 1, 0)), 1.0 / (64.0 * 64.0), 1e-9);
  EXPECT_NEAR(texture_per_m2(facets.at(6, 1, 1)), 0.5 / (64.0 * 64.0), 1e-9);
}

TEST(PaperWhite, CoversFacetsOfEveryPhiAlikeByPoissonsLaw) {
  const Facets facets(edge(), 2.0);
  for (double gamma : {0.0, 0.1, 0.25, 1.0}) {
    const FactorMap white = paper_white(facets, 64.0, gamma, 1025, 5);
    double level = 0.0, steep = 0.0;
    for (int j = 0; j < 1025; ++j)
      for (int i = 0; i < 512; ++i) level += white.at(i, j), steep += white.at(i + 513, j);
    const double expected = 1.0 - std::exp(-4.0 * gamma);
    EXPECT_NEAR(level / (512 * 1025), expected, 3e-3);  // four deviations of so many texels
    EXPECT_NEAR(steep / (512 * 1025), expected, 3e-3);
  }
}

TEST(PaperWhite, OnlyGrows) {
  const Facets facets(edge(), 800.0);
  const FactorMap before = paper_white(facets, 64.0, 0.2, 129, 5);
  const FactorMap after = paper_white(facets, 64.0, 0.3, 129, 5);
  for (std::size_t i = 0; i < before.values().size(); ++i)
    ASSERT_LE(before.values()[i], after.values()[i]);
}

}  // namespace
}  // namespace wold::snow
