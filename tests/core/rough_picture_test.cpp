#include "core/rough_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

Image noise(int width, int height) {
  std::mt19937 random(3);
  std::lognormal_distribution<float> number(-4.0F, 0.5F);
  Image image(width, height, 3);
  for (float& value : image.values) value = number(random);
  return image;
}

/// Of a positive number, how many half floats lie below it: 1024 in each octave.
double half_steps(float value) {
  int exponent = 0;
  const double fraction = std::frexp(double{value}, &exponent);
  return 1024.0 * (exponent + 2.0 * fraction);
}

/// The largest error of a block of a channel, in the block's range.
double worst_in_block(const Image& got, const Image& want, int x, int y, int channel) {
  double low = 1e9, high = -1e9, worst = 0.0;
  for (int row = y; row < std::min(y + 4, want.height); ++row)
    for (int column = x; column < std::min(x + 4, want.width); ++column) {
      const double wanted = half_steps(want.pixel(column, row)[channel]);
      low = std::min(low, wanted);
      high = std::max(high, wanted);
      worst = std::max(worst, std::abs(half_steps(got.pixel(column, row)[channel]) - wanted));
    }
  return worst / std::max(high - low, 64.0);
}

TEST(RoughPicture, IsTrueToAThirtiethOfEachBlocksRange) {
  const test::TemporaryFolder folder("rough");
  const Image want = noise(62, 45);  // the last blocks are cut off
  write_rough_picture(folder.path() / "a.exr", want);
  const Image got = read_image(folder.path() / "a.exr");
  ASSERT_EQ(got.width, want.width);
  ASSERT_EQ(got.height, want.height);
  double worst = 0.0;
  for (int y = 0; y < want.height; y += 4)
    for (int x = 0; x < want.width; x += 4)
      for (int channel = 0; channel < 3; ++channel)
        worst = std::max(worst, worst_in_block(got, want, x, y, channel));
  EXPECT_LT(worst, 1.0 / 30.0);
  EXPECT_GT(worst, 0.0);
}

TEST(RoughPicture, TakesSevenSixteenthsOfItsHalfFloats) {
  const test::TemporaryFolder folder("rough_size");
  write_rough_picture(folder.path() / "a.exr", noise(256, 256));
  EXPECT_NEAR(static_cast<double>(std::filesystem::file_size(folder.path() / "a.exr")),
              256 * 256 * 3 * 2 * 7.0 / 16.0, 2000.0);
}

TEST(RoughPicture, SamePictureSameBytes) {
  const test::TemporaryFolder folder("rough_bytes");
  for (const char* name : {"a.exr", "b.exr"})
    write_rough_picture(folder.path() / name, noise(40, 30));
  EXPECT_EQ(read_file(folder.path() / "a.exr"), read_file(folder.path() / "b.exr"));
}

}  // namespace
}  // namespace wold
