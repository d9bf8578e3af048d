#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "expectation/bare_view.h"
#include "expectation/blades_appearance.h"
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

TEST(BareView, SeesTheFinerPictureOfTheGroundWhereThereIsOne) {
  landscape::Landscape landscape;
  landscape.ground = ColourMap(65, 64.0, glm::vec3(0.1F));
  landscape.ground_details = {{ColourMap(65, 16.0, glm::vec3(0.4F)), {8.0, 8.0}}};
  const auto seen = [&](const glm::dvec2& at_m) {
    return bare_view(landscape, {at_m, 2.0}, {0.0, 0.0, -1.0}, 2.0).radiance.g;
  };
  EXPECT_FLOAT_EQ(seen({16.0, 16.0}), 0.4F);
  EXPECT_FLOAT_EQ(seen({40.0, 16.0}), 0.1F);
  EXPECT_NEAR(seen({8.0 + 1.0, 16.0}), 0.25, 1e-5);  // half of the soft border of two steps
}

// A bar that lies hides its own width times its length from above, whatever it is below.
TEST(BladesAppearance, OfALyingBarIsItsWidth) {
  constexpr float width_m = 0.02F, length_m = 0.8F;
  constexpr double ground_m2 = 0.5;
  Tubes bar;
  bar.rings = 2;
  bar.corners = 4;
  for (const float x : {0.0F, length_m})
    for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      bar.vertices_m.emplace_back(x, 0.5F * width_m * corner.x, 0.1F + 0.5F * width_m * corner.y);
  bar.radiance.assign(2, glm::vec3(1.0F));
  const BladesAppearance blades(bar, ground_m2);
  const double seen = blades.trace({.direction = {0.0, 0.0, -1.0}}).transmittance;
  EXPECT_NEAR(seen, math::exp(-double{width_m * length_m} / ground_m2), 1e-4);
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
