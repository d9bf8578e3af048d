#include "place/topography.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "terrain/hillside.h"

namespace wold::place {
namespace {

/// Ridges and troughs that run north, 10 m from crest to crest and 2 m high: troughs at 0, 10, ...
Heightfield troughs(double size_m) {
  Heightfield terrain(129, size_m);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) =
          static_cast<float>(-std::cos(2.0 * std::numbers::pi * i * terrain.step_m() / 10.0));
  return terrain;
}

/// A plane that rises by `rise` m per metre to the east and to the north.
Heightfield plane(const glm::dvec2& rise) {
  Heightfield terrain(33, 40.0);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i)
      terrain.at(i, j) = static_cast<float>(glm::dot(rise, terrain.place_m(i, j)));
  return terrain;
}

TEST(Topography, TroughsAreWetAndCrestsDry) {
  const Topography topography(troughs(40.0), 47.0);
  for (const double y_m : {5.0, 20.0, 33.0}) {
    EXPECT_GT(topography.wetness({20.0, y_m}), 0.9);
    EXPECT_LT(topography.wetness({15.0, y_m}), 0.1);
    EXPECT_NEAR(topography.wetness({17.5, y_m}), 0.5, 0.1);
  }
}

// Ranks are even: as much of any terrain is wetter than 0.7 as of another.
TEST(Topography, WetnessIsTheFractionThatIsDrier) {
  scene::Scene scene;
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  const Topography topography(terrain, 47.0);
  for (const double limit : {0.2, 0.5, 0.9}) {
    int drier = 0;
    constexpr int places = 200;
    for (int k = 0; k < places * places; ++k) {
      const glm::dvec2 at_m =
          (glm::dvec2(k % places, k / places) + 0.5) * (terrain.size_m() / places);
      drier += topography.wetness(at_m) < limit;
    }
    EXPECT_NEAR(drier / (1.0 * places * places), limit, 0.02) << limit;
  }
}

TEST(Topography, LevelGroundIsNeitherWetNorDry) {
  const Topography topography(plane(glm::dvec2(0.0)), 47.0);
  EXPECT_NEAR(topography.wetness({3.0, 30.0}), 0.5, 1e-6);
  EXPECT_NEAR(topography.sun({3.0, 30.0}), 1.0, 1e-6);
}

// At the equinox the noon sun stands 43 degrees high at 47 degrees north, in the south.
TEST(Topography, SouthernSlopesAreSunny) {
  const double slope = 20.0 * std::numbers::pi / 180.0;
  const double latitude = 47.0 * std::numbers::pi / 180.0;
  const double south = Topography(plane({0.0, std::tan(slope)}), 47.0).sun({20.0, 20.0});
  const double north = Topography(plane({0.0, -std::tan(slope)}), 47.0).sun({20.0, 20.0});
  const double east = Topography(plane({-std::tan(slope), 0.0}), 47.0).sun({20.0, 20.0});
  EXPECT_NEAR(south, std::cos(latitude - slope) / std::cos(latitude), 1e-4);
  EXPECT_NEAR(north, std::cos(latitude + slope) / std::cos(latitude), 1e-4);
  EXPECT_NEAR(east, std::cos(slope), 1e-4);
}

}  // namespace
}  // namespace wold::place
