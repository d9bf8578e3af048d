#include "blender/colour_picture.h"

#include <gtest/gtest.h>

namespace wold::blender {
namespace {

/// 3 x 3 x 2 colours, each another one: red says x, green y, blue z.
landscape::ColourGrid numbered() {
  landscape::ColourGrid colours{{3, 3, 2}, {}};
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) colours.values.emplace_back(x, y, z);
  return colours;
}

TEST(ColourPicture, IsAColumnOfSlices) {
  const landscape::ColourGrid colours = numbered();
  const ColourPicture picture = colour_picture_of(colours);
  EXPECT_EQ(picture.side, 3);
  EXPECT_EQ(picture.slices, 4);
  EXPECT_EQ(picture.scale, 2.0F);
  const Image pixels = pixels_of(picture, colours);
  ASSERT_EQ(pixels.width, 5);
  ASSERT_EQ(pixels.height, 20);
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const float* pixel = pixels.pixel(1 + x, 5 * (1 + z) + 1 + y);
        EXPECT_EQ(glm::vec3(pixel[0], pixel[1], pixel[2]), glm::vec3(x, y, z) / 2.0F);
      }
}

// So that interpolation goes on beyond the patch, which repeats itself, and below and above it.
TEST(ColourPicture, BordersRepeatWhatIsBeyondThem) {
  const landscape::ColourGrid colours = numbered();
  const Image pixels = pixels_of(colour_picture_of(colours), colours);
  const auto red_and_green = [&](int x, int y) {
    const float* pixel = pixels.pixel(x, 5 + y);
    return glm::vec2(pixel[0], pixel[1]) * 2.0F;
  };
  EXPECT_EQ(red_and_green(0, 1), glm::vec2(2, 0));
  EXPECT_EQ(red_and_green(4, 1), glm::vec2(0, 0));
  EXPECT_EQ(red_and_green(1, 0), glm::vec2(0, 2));
  EXPECT_EQ(red_and_green(1, 4), glm::vec2(0, 0));
  EXPECT_EQ(pixels.pixel(2, 2)[2], pixels.pixel(2, 7)[2]);
  EXPECT_EQ(pixels.pixel(2, 17)[2], pixels.pixel(2, 12)[2]);
}

TEST(ColourPicture, OfDarknessIsBlack) {
  const landscape::ColourGrid colours{{1, 1, 1}, {glm::vec3(0.0F)}};
  for (const float value : pixels_of(colour_picture_of(colours), colours).values)
    EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace wold::blender
