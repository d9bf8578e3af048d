#include "scene/key_frames.h"

#include <gtest/gtest.h>

namespace wold::scene {
namespace {

TEST(KeyFrames, AreTwelveStepsForAFewPictures) {
  const Scene scene;
  const std::vector<double> degrees = key_frames(scene);
  ASSERT_EQ(degrees.size(), 13U);
  EXPECT_EQ(degrees.front(), 0.0);
  EXPECT_DOUBLE_EQ(degrees[1], 1.0 / 12.0);
  EXPECT_EQ(degrees.back(), 1.0);
}

TEST(KeyFrames, AreAsNearToEachOtherAsTheFramesOfAFilm) {
  Scene scene;
  scene.ageing.frames = {0.0, 0.05, 0.05, 0.09, 0.13};
  EXPECT_EQ(key_frames(scene).size(), 26U);     // steps of 0.04
  scene.ageing.frames = {0.0, 0.05, 0.5, 1.0};  // the least of them, wherever it is
  EXPECT_EQ(key_frames(scene).size(), 21U);
  scene.ageing.frames = {0.5, 0.501};
  EXPECT_EQ(key_frames(scene).size(), 49U);
}

TEST(KeyFrames, AreTheUsersOwn) {
  Scene scene;
  scene.grass.key_frames = {0.0, 0.4, 1.0};
  EXPECT_EQ(key_frames(scene), scene.grass.key_frames);
}

}  // namespace
}  // namespace wold::scene
