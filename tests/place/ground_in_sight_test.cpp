#include "place/ground_in_sight.h"

#include <gtest/gtest.h>

#include "core/mesh_height.h"
#include "place/view.h"
#include "support/sees_ground.h"
#include "terrain/ground.h"

namespace wold::place {
namespace {

Heightfield mountain() {
  scene::Terrain terrain;
  terrain.shape = scene::TerrainShape::mountain;
  terrain.size_m = 3000.0;
  terrain.hill_height_m = 500.0;
  terrain.samples = 129;
  return terrain::make_ground(terrain, 5).heights_m;
}

glm::dvec3 eye_over(const Heightfield& terrain, const glm::dvec2& at_m) {
  return {at_m, double{mesh_height_m(terrain, at_m)} + 1.7};
}

// All that lines of sight reach is seen, and most of what they do not reach is known to be hidden,
// whichever way one looks.
TEST(GroundInSight, IsWhatLinesOfSightReach) {
  const Heightfield terrain = mountain();
  for (const glm::dvec2 stands_m : {glm::dvec2(1500.0, 700.0), glm::dvec2(300.0, 2400.0)}) {
    const glm::dvec3 eye_m = eye_over(terrain, stands_m);
    const GroundInSight sight(terrain, eye_m);
    int hidden = 0, found = 0, seen = 0;
    for (double y = 7.0; y < 3000.0; y += 23.0)
      for (double x = 5.0; x < 3000.0; x += 23.0) {
        constexpr double margin_m = 1.0;
        const bool may_be_seen = sight.may_see({x, y}, margin_m);
        if (test::sees_ground(terrain, eye_m, {x, y}, /*step_m=*/1.5)) {
          ++seen;
          EXPECT_TRUE(may_be_seen) << x << ' ' << y;
        } else {
          ++hidden;
          found += may_be_seen ? 0 : 1;
        }
      }
    EXPECT_GT(seen, 500);
    EXPECT_GT(hidden, 5000);
    EXPECT_GT(found, 0.85 * hidden);
  }
}

// What stands in the shade of a wall is seen as soon as the margin reaches over it.
TEST(GroundInSight, HasTheMarginAroundPlaces) {
  Heightfield terrain(101, 100.0);
  for (int j = 0; j < terrain.samples(); ++j) terrain.at(50, j) = 5.0F;
  const GroundInSight sight(terrain, {40.0, 50.0, 2.0});
  // The wall is 3 m over the eye and 10 m away: behind it, 20 m away, 6 m over the eye are free.
  EXPECT_FALSE(sight.may_see({60.0, 50.0}, 5.0));
  EXPECT_TRUE(sight.may_see({60.0, 50.0}, 8.1));
  EXPECT_TRUE(sight.may_see({45.0, 50.0}, 0.1));
  EXPECT_TRUE(sight.may_see({20.0, 50.0}, 0.1));
  EXPECT_TRUE(sight.may_see({50.0, 50.0}, 0.1));
}

// A view that knows no ground sees through it.
TEST(GroundInSight, HidesNothingFromAViewWithoutIt) {
  Heightfield terrain(101, 100.0);
  for (int j = 0; j < terrain.samples(); ++j) terrain.at(50, j) = 5.0F;
  const View view({{40.0, 50.0, 2.0}, {80.0, 50.0, 2.0}, 60.0}, 160, 90);
  EXPECT_TRUE(view.may_see_ground({60.0, 50.0, 0.0}, 1.0));
  EXPECT_FALSE(view.over(terrain).may_see_ground({60.0, 50.0, 0.0}, 1.0));
  EXPECT_FALSE(view.over(terrain).may_see_ground({20.0, 50.0, 0.0}, 1.0));
}

}  // namespace
}  // namespace wold::place
