#include "ground/land_variety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/normal_distribution.h"

namespace wold::ground {
namespace {

/// So many bushes of 1000 places, which are dark; what is between them makes up for it.
std::vector<glm::vec3> bushes_of_thousand(int bushes) {
  std::vector<glm::vec3> places(
      1000, glm::vec3(0.6F * static_cast<float>(bushes) / static_cast<float>(1000 - bushes)));
  for (int i = 0; i < bushes; ++i)
    places[static_cast<std::size_t>(7 * i % 1000)] = glm::vec3(-0.6F);
  return places;
}

TEST(LandVariety, HasAsManyOfEachAsThereAre) {
  const LandVariety land(bushes_of_thousand(80));
  EXPECT_NEAR(land.at(normal_quantile(0.04), 1.0).g, -0.6F, 0.02F);
  for (const double rank : {0.15, 0.5, 0.9})
    EXPECT_NEAR(land.at(normal_quantile(rank), 1.0).g, 0.052F, 0.02F) << rank;
}

// What is too fine to be shown counts by its mean: far land is neither brighter nor darker.
TEST(LandVariety, KeepsItsMeanHoweverLittleIsShown) {
  std::vector<glm::vec3> places = bushes_of_thousand(200);
  for (glm::vec3& place : places) place -= 0.1F;  // as they are where bright ones were cut off
  const LandVariety land(places);
  for (const double shown : {0.0, 0.1, 0.4, 0.7, 1.0}) {
    constexpr int values = 2000;
    double sum = 0.0;
    for (int i = 0; i < values; ++i) {
      const double known = std::sqrt(shown) * normal_quantile((i + 0.5) / values);
      sum += double{land.at(known, shown).g} / values;
    }
    EXPECT_NEAR(sum, 0.0, 0.01) << shown;
  }
}

TEST(LandVariety, DiffersLessTheLessIsShown) {
  const LandVariety land(bushes_of_thousand(80));
  EXPECT_NEAR(land.at(0.0, 0.0).g, 0.0F, 1e-3F);
  // By the conditional distribution: a bush where 0.6 z - 0.8 is below the quantile of 0.08.
  const double bush = normal_cdf((normal_quantile(0.08) + 0.8) / 0.6);
  EXPECT_NEAR(land.at(-0.8, 0.64).g, -0.6 * bush + 0.052 * (1.0 - bush), 0.03);
}

// Straw stands here and there in green grass: it is redder, and no brighter in green.
TEST(LandVariety, DiffersInTheColoursOfItsPlaces) {
  const glm::vec3 grass(-0.33F, 0.0F, -0.33F), straw(0.33F, 0.0F, 0.33F);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 400; ++i) places.push_back(i % 2 == 0 ? grass : straw);
  const LandVariety land(places);
  EXPECT_NEAR(land.at(1.0, 1.0).r, straw.r, 0.01F);
  EXPECT_NEAR(land.at(1.0, 1.0).g, straw.g, 0.01F);
  EXPECT_NEAR(land.at(-1.0, 1.0).b, grass.b, 0.01F);
}

// Dark places are bluish, bright ones reddish, by as much: no start of an iteration is across that.
TEST(LandVariety, KnowsColoursThatDifferOppositely) {
  std::vector<glm::vec3> places;
  for (int i = 0; i < 400; ++i)
    places.push_back(i % 2 == 0 ? glm::vec3(0.2F, 0.0F, -0.2F) : glm::vec3(-0.2F, 0.0F, 0.2F));
  const glm::vec3 end = LandVariety(places).at(1.0, 1.0);
  EXPECT_NEAR(std::abs(end.r), 0.2F, 0.01F);
  EXPECT_NEAR(end.r + end.b, 0.0F, 0.01F);
}

// Fewer than it has ranks, or not as many in each.
TEST(LandVariety, KnowsAnyNumberOfPlaces) {
  for (const std::size_t count : {1U, 3U, 65U, 100U}) {
    std::vector<glm::vec3> places;
    for (std::size_t i = 0; i < count; ++i)
      places.emplace_back(static_cast<float>(i) - 0.5F * static_cast<float>(count - 1));
    const LandVariety land(places);
    EXPECT_NEAR(land.at(0.0, 0.0).g, 0.0F, 0.5F) << count;
    EXPECT_NEAR(land.at(3.0, 1.0).g, places.back().g, 1.0F) << count;
    EXPECT_NEAR(land.at(-3.0, 1.0).g, places.front().g, 1.0F) << count;
  }
}

TEST(LandVariety, OfNoPlacesIsNone) { EXPECT_EQ(LandVariety({}).at(2.0, 1.0), glm::vec3(0.0F)); }

}  // namespace
}  // namespace wold::ground
