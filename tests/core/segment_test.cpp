#include "core/segment.h"

#include <gtest/gtest.h>

#include "core/samples_between.h"

namespace wold {
namespace {

TEST(Segment, HasItsNearestPlaceWithinIt) {
  const glm::dvec2 begin(1.0, 1.0), end(5.0, 4.0);                 // 5 long
  EXPECT_NEAR(share_of_way({4.0, -3.0}, begin, end), 0.0, 1e-12);  // square to its begin
  EXPECT_NEAR(share_of_way({3.0 - 3.0, 2.5 + 4.0}, begin, end), 0.5, 1e-12);
  EXPECT_EQ(share_of_way({-9.0, 0.0}, begin, end), 0.0);
  EXPECT_EQ(share_of_way({9.0, 9.0}, begin, end), 1.0);
  EXPECT_EQ(share_of_way({9.0, 9.0}, begin, begin), 0.0);
}

TEST(SamplesBetween, AreThoseOfTheGrid) {
  const GroundGrid grid{{{10.0, 0.0}, 4.0}, 9};  // steps of 0.5
  EXPECT_EQ(samples_between(11.0, 12.2, 10.0, grid), glm::ivec2(2, 4));
  EXPECT_EQ(samples_between(-50.0, 50.0, 10.0, grid), glm::ivec2(0, 8));
  for (const double beside_m : {2.0, 10.6, 20.0}) {
    const glm::ivec2 none = samples_between(beside_m, beside_m + 0.3, 10.0, grid);
    EXPECT_GT(none[0], none[1]) << beside_m;
  }
}

}  // namespace
}  // namespace wold
