#include "light/white_balance.h"

#include <gtest/gtest.h>

#include "core/colour.h"

namespace wold::light {
namespace {

glm::dvec3 rgb_of(double x, double y) {
  return srgb_from_xyz(glm::dvec3(x / y, 1.0, (1.0 - x - y) / y));
}

// CIE 015:2018: chromaticities and correlated colour temperatures of standard daylights.
TEST(WhiteBalance, KnowsTheDaylightsOfTables) {
  struct Row {
    double temperature_K, x, y;
  };
  for (const Row& row : {Row{5003.0, 0.34567, 0.35850}, Row{5503.0, 0.33242, 0.34743},
                         Row{6504.0, 0.31271, 0.32902}, Row{7504.0, 0.29902, 0.31485}}) {
    EXPECT_NEAR(colour_temperature_K(rgb_of(row.x, row.y)), row.temperature_K, 15.0);
    const glm::dvec3 xyz = xyz_from_srgb(daylight_colour(row.temperature_K));
    EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), row.x, 1e-3) << row.temperature_K;
    EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), row.y, 1e-3) << row.temperature_K;
    EXPECT_NEAR(xyz.y, 1.0, 1e-9);
  }
}

TEST(WhiteBalance, FollowsTheDay) {
  for (const double temperature_K : {4500.0, 5500.0, 6500.0, 6900.0}) {
    const glm::dvec3 light = 30.0 * daylight_colour(temperature_K);
    EXPECT_EQ(camera_white(light), light);
  }
}

// Of what is bluer than a camera's balance reaches the rest is seen, as it is seen by one that is
// set to 7000 K.
TEST(WhiteBalance, LeavesDuskBlue) {
  const glm::dvec3 set = daylight_colour(7000.0);
  for (const double temperature_K : {9000.0, 15000.0}) {
    const glm::dvec3 light = 0.2 * daylight_colour(temperature_K);
    const glm::dvec3 white = camera_white(light);
    EXPECT_NEAR(luminance(light / white), 1.0, 1e-12);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(white[c] / white.g, set[c] / set.g, 0.01) << temperature_K;
    EXPECT_GT(light.b / white.b, 1.1 * light.r / white.r);
  }
  const glm::dvec3 before = camera_white(daylight_colour(6995.0)),
                   after = camera_white(daylight_colour(7005.0));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(before[c], after[c], 2e-3);
}

}  // namespace
}  // namespace wold::light
