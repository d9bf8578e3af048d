#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "expectation/bare_view.h"
#include "expectation/cloud_view.h"

namespace wold::expectation {
namespace {

constexpr double nowhere_m = std::numeric_limits<double>::infinity();

glm::dvec3 towards(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * std::numbers::pi / 180.0;
  const double e = elevation_deg * std::numbers::pi / 180.0;
  return {math::sin(a) * math::cos(e), math::cos(a) * math::cos(e), math::sin(e)};
}

// Landscape::sky has north on its left edge, goes by the east, and has the zenith above.
TEST(BareView, FindsThePlaceOfTheSkysPicture) {
  landscape::Landscape landscape;
  landscape.sky = Image(8, 4, 3);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 8; ++column) {
      landscape.sky.pixel(column, row)[0] = static_cast<float>(column);
      landscape.sky.pixel(column, row)[1] = static_cast<float>(row);
    }
  const auto seen = [&](double azimuth_deg, double elevation_deg) {
    return bare_view(landscape, glm::dvec3(0.0), towards(azimuth_deg, elevation_deg), nowhere_m)
        .radiance;
  };
  EXPECT_NEAR(seen(112.5, 22.5).r, 2.0, 1e-4);  // a little south of east
  EXPECT_NEAR(seen(292.5, 22.5).r, 6.0, 1e-4);
  EXPECT_NEAR(seen(112.5, 67.5).g, 0.0, 1e-4);
  EXPECT_NEAR(seen(112.5, -22.5).g, 2.0, 1e-4);
}

/// A box of one voxel, 10 m wide and hardly to be seen through, `ahead_m` to the north.
std::vector<landscape::CloudBox> one_cloud(double ahead_m) {
  landscape::CloudBox box;
  box.voxels = {1, 1, 1};
  box.voxel_m = 10.0;
  box.corner_m = {-5.0, ahead_m - 5.0, -5.0};
  box.extinction_per_m = {0.5F};
  box.radiance = {glm::vec3(0.3F)};
  return {box};
}

TEST(CloudView, IsOfWhatLiesBeforeTheEyeAndBeforeTheGround) {
  const auto through = [](double ahead_m, double ground_m) {
    return cloud_view(one_cloud(ahead_m), glm::dvec3(0.0), {0.0, 1.0, 0.0}, ground_m)
        .look.transmittance;
  };
  EXPECT_LT(through(50.0, nowhere_m), 0.01);
  EXPECT_EQ(through(-50.0, nowhere_m), 1.0);
  EXPECT_EQ(through(50.0, 30.0), 1.0);
}

}  // namespace
}  // namespace wold::expectation
