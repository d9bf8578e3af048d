#include "scene/sun_path.h"

#include <gtest/gtest.h>

#include "problems.h"

namespace wold::scene {
namespace {

TEST(SunPath, GoesEvenlyAndByTheShorterWayAround) {
  Scene scene;
  EXPECT_FALSE(sun_moves(scene));
  EXPECT_EQ(sun_at(scene, 0.7), scene.sun);
  scene.sun.elevation_deg = 21.0;
  scene.sun.azimuth_deg = 350.0;
  scene.sun.end = {1.0, 10.0};
  EXPECT_TRUE(sun_moves(scene));
  EXPECT_DOUBLE_EQ(sun_at(scene, 0.0).elevation_deg, 21.0);
  EXPECT_DOUBLE_EQ(sun_at(scene, 0.5).elevation_deg, 11.0);
  EXPECT_DOUBLE_EQ(sun_at(scene, 0.5).azimuth_deg, 360.0);
  EXPECT_DOUBLE_EQ(sun_at(scene, 1.0).elevation_deg, 1.0);
  EXPECT_DOUBLE_EQ(sun_at(scene, 1.0).azimuth_deg, 370.0);
}

TEST(SunPath, SaysWhatContradictsItself) {
  EXPECT_TRUE(problems_of("[sun]\nend = [1, 300]\n").empty());
  expect_problem("[sun]\nend = [1]\n", "a.toml:2:1: sun.end: found a list of 1, expected two");
  EXPECT_TRUE(problems_of("[sun]\nend = [-4, 300]\n").empty());
  expect_problem("[sun]\nend = [-4.5, 300]\n", "a.toml:2:8: sun.end: ");
  expect_problem("[sun]\nend = [91, 300]\n",
                 "a.toml:2:1: sun.end: found [91, 300] degrees, expected a height of -4 to 90 and");
  expect_problem("[sun]\nend = [10, -1]\n",
                 "a.toml:2:1: sun.end: found [10, -1] degrees, expected a height of -4 to 90 and a "
                 "direction of 0 to 360");
  expect_problem("[sun]\ndate = [2026, 6, 1]\nend = [20, 300]\n",
                 "a.toml:3:1: sun.end: found a place, but the sun stands where it stood on a day");
}

}  // namespace
}  // namespace wold::scene
