#include "place/view.h"

#include <gtest/gtest.h>

namespace wold::place {
namespace {

// Twice as wide as high, 90 degrees across: the picture's edges are 1 and 0.5 to the side of what
// is 1 ahead.
TEST(View, SeesWhatIsInsideThePicture) {
  const View view({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100);
  const auto sees = [&](double right, double up) {
    return view.may_see({10.0 * right, 10.0, 10.0 * up}, 1e-6);
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(sees(0.99 * sign, 0.0));
    EXPECT_FALSE(sees(1.01 * sign, 0.0));
    EXPECT_TRUE(sees(0.0, 0.49 * sign));
    EXPECT_FALSE(sees(0.0, 0.51 * sign));
  }
  EXPECT_FALSE(view.may_see({0, -1, 0}, 0.5));
  EXPECT_TRUE(view.may_see({0, -1, 0}, 1.5));
}

TEST(View, MeasuresLengthsInPixels) {
  const View view({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100);
  EXPECT_NEAR(view.pixels(1.0, {0, 10, 0}), 10.0, 1e-9);
  EXPECT_NEAR(view.pixels(1.0, {0, 6, 8}), 10.0, 1e-9);
}

// Between four heights of which two opposite ones are 8 m higher, bilinear ground is 4 m high. The
// mesh of renderers is cut from south-west to north-east: through the low ones or the high ones.
TEST(Camera, StandsOverTheMesh) {
  constexpr double step_m = 30.0;
  scene::Camera camera;
  camera.eye_m = {0.5 * step_m, 0.5 * step_m};
  camera.eye_height_m = 1.7;
  camera.target_m = {0.5 * step_m, 0.25 * step_m};
  camera.target_height_m = 0.0;
  Heightfield terrain(2, step_m);
  terrain.at(1, 0) = terrain.at(0, 1) = 8.0F;
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).eye_m.z, 1.7, 1e-6);
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).target_m.z, 2.0, 1e-6);
  terrain.at(0, 0) = terrain.at(1, 1) = 16.0F;
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).eye_m.z, 17.7, 1e-6);
  EXPECT_NEAR(resolved_camera(camera, terrain, 0.0).target_m.z, 14.0, 1e-6);
}

}  // namespace
}  // namespace wold::place
