#include "place/ground_grids.h"

#include <gtest/gtest.h>

#include "place/view.h"

namespace wold::place {
namespace {

scene::Scene seen_in(int width_px) {
  scene::Scene scene;
  scene.terrain.size_m = 48.0;
  scene.render.size_px = {width_px, width_px * 9 / 16};
  return scene;
}

// A rock ten metres off is as sharp in a large picture as in a small one.
TEST(PictureGrid, IsAsFineAsTheScenesPicture) {
  const double away_m = 48.0 / 5.0;
  for (const int width_px : {960, 1920}) {
    const scene::Scene scene = seen_in(width_px);
    const double pixel_m = away_m / pixels_per_radian(scene);
    EXPECT_LE(picture_grid(scene).step_m(), 2.5 * pixel_m) << width_px;
  }
  EXPECT_NEAR(picture_grid(seen_in(96)).step_m(), 0.03, 1e-4);
}

TEST(PictureGrid, HasBoundsForAnyView) {
  scene::Scene scene = seen_in(8192);
  scene.camera.field_of_view_deg = 1e-3;
  EXPECT_EQ(picture_grid(scene).samples, 4097);
  scene.terrain.size_m = 1.0;
  EXPECT_NEAR(picture_grid(scene).step_m(), 0.005, 1e-4);
  scene.terrain.size_m = 1200.0;
  EXPECT_EQ(picture_grid(scene).samples, 4097);
}

// A slope straight ahead is drawn in steps of hardly more than a pixel, however far away it is; so
// is no more made than that takes.
TEST(DetailGrids, AreAsFineAsTheScenesPicture) {
  scene::Scene scene = seen_in(960);
  scene.terrain.size_m = 20e3;
  const landscape::Camera camera{{9e3, 8e3, 2.0}, {9e3, 9e3, 2.0}, 55.0};
  GroundGrid coarse = whole_grid(scene);
  for (const GroundGrid& fine : detail_grids(scene, camera)) {
    const double north_m = fine.square.corner_m.y + fine.square.size_m;
    const double pixels = coarse.step_m() / (north_m - camera.eye_m.y) * pixels_per_radian(scene);
    EXPECT_LE(pixels, coarse.square.size_m > 150.0 ? 1.71 : 3.4) << coarse.square.size_m;
    EXPECT_GE(pixels, 1.2) << coarse.square.size_m;
    coarse = fine;
  }
  EXPECT_LE(coarse.step_m(), 0.01);
}

}  // namespace
}  // namespace wold::place
