#include "compare/images.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace wold::compare {
namespace {

constexpr double soft = 0.02;

Image filled(int width, int height, float value, int channels = 3) {
  Image image(width, height, channels);
  image.values.assign(image.values.size(), value);
  return image;
}

/// Columns of black and white: the finest texture there is.
Image stripes(int width, int height, int shift) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<float>((x + shift) % 2);
  return image;
}

TEST(CompareImages, AConstantOffsetIsTheRmse) {
  const ImageMetrics metrics = compare_images(filled(40, 30, 0.5F), filled(40, 30, 0.25F), soft);
  EXPECT_DOUBLE_EQ(metrics.rmse, 0.25);
  EXPECT_DOUBLE_EQ(metrics.mean_abs, 0.25);
  EXPECT_DOUBLE_EQ(metrics.max_error, 0.25);
  EXPECT_DOUBLE_EQ(metrics.fraction_over_soft, 1.0);
  EXPECT_NEAR(metrics.psnr_db, 20.0 * std::log10(4.0), 1e-12);
  for (double shift : metrics.mean_shift) EXPECT_DOUBLE_EQ(shift, 0.25);
}

TEST(CompareImages, OnePixelOff) {
  Image got = filled(40, 30, 0.25F);
  got.pixel(7, 19)[1] = 0.75F;
  const ImageMetrics metrics = compare_images(got, filled(40, 30, 0.25F), soft);
  EXPECT_DOUBLE_EQ(metrics.max_error, 0.5);
  EXPECT_EQ(metrics.worst_px, glm::ivec2(7, 19));
  EXPECT_DOUBLE_EQ(metrics.fraction_over_soft, 1.0 / 1200.0);
  EXPECT_NEAR(metrics.rmse, 0.5 / std::sqrt(3600.0), 1e-15);
  EXPECT_DOUBLE_EQ(metrics.mean_shift[0], 0.0);
}

TEST(CompareImages, EqualPictures) {
  const ImageMetrics metrics = compare_images(stripes(16, 16, 0), stripes(16, 16, 0), soft);
  EXPECT_EQ(metrics.rmse, 0.0);
  EXPECT_EQ(metrics.mean_delta_e, 0.0);
  EXPECT_EQ(metrics.psnr_db, std::numeric_limits<double>::infinity());
}

TEST(CompareImages, BlurForgivesAShiftButNotABrightness) {
  const ImageMetrics shifted = compare_images(stripes(256, 32, 0), stripes(256, 32, 1), soft);
  EXPECT_DOUBLE_EQ(shifted.mean_abs, 1.0);
  EXPECT_LT(shifted.mean_abs_blurred8, 0.02);  // only the border is left
  const ImageMetrics brighter = compare_images(filled(32, 32, 0.5F), filled(32, 32, 0.25F), soft);
  EXPECT_NEAR(brighter.mean_abs_blurred8, 0.25, 1e-6);
}

TEST(CompareImages, DeltaEOfBlackAndWhiteIs100AndOfRedAsPublished) {
  EXPECT_NEAR(compare_images(filled(4, 4, 1.0F), filled(4, 4, 0.0F), soft).mean_delta_e, 100.0,
              1e-9);
  Image red = filled(4, 4, 0.0F);
  for (int i = 0; i < 16; ++i) red.values[static_cast<std::size_t>(3 * i)] = 1.0F;
  // L*a*b* of sRGB red is 53.24, 80.09, 67.20 (Lindbloom, D65)
  EXPECT_NEAR(compare_images(red, filled(4, 4, 0.0F), soft).mean_delta_e,
              std::hypot(53.24, 80.09, 67.20), 0.05);
}

TEST(CompareImages, ValuesThatAreNoNumbersAreCountedNotSummed) {
  Image got = filled(8, 8, 0.25F);
  got.pixel(1, 1)[0] = std::nanf("");
  got.pixel(2, 2)[0] = std::numeric_limits<float>::infinity();
  const ImageMetrics metrics = compare_images(got, filled(8, 8, 0.25F), soft);
  EXPECT_EQ(metrics.non_finite, 2U);
  EXPECT_EQ(metrics.rmse, 0.0);
  EXPECT_EQ(metrics.mean_abs_blurred8, 0.0);
  EXPECT_THAT(exceeded(measures(metrics, Limits{})),
              testing::Contains("values that are not finite is 2, at most 0 is allowed"));
}

// The ends of Matplotlib's table of magma, which the paper takes, encoded sRGB.
TEST(FlipPicture, GoesFromBlackToPaleYellow) {
  Image map(2, 1, 1);
  map.values = {0.0F, 1.0F};
  const Image picture = flip_picture(map);
  const std::array<double, 6> want = {0.0015, 0.0005, 0.0139, 0.9871, 0.9914, 0.7495};
  ASSERT_EQ(picture.values.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) EXPECT_NEAR(picture.values[i], want[i], 0.01);
}

TEST(CompareImages, OtherShapesAreNamed) {
  EXPECT_EQ(shape_difference(filled(4, 3, 0.0F), filled(4, 3, 0.0F, 4)),
            "got 4 x 3 pixels with 3 channels, want 4 x 3 with 4");
  EXPECT_THROW(compare_images(filled(4, 3, 0.0F), filled(3, 4, 0.0F), soft), std::invalid_argument);
}

TEST(ExceededLimits, ReachingALimitIsAllowed) {
  const Limits limits{.rmse = 0.125, .soft = 0.125, .allowed_fraction = 0.25, .hard = 0.25};
  DifferenceSum sum(limits.soft);
  for (double difference : {0.25, 0.0, 0.0, 0.0}) {
    sum.add(difference, 0.0);
    sum.end_sample();
  }
  EXPECT_DOUBLE_EQ(sum.result().fraction_over_soft, 0.25);
  EXPECT_TRUE(exceeded(measures(sum.result(), limits)).empty());
  EXPECT_EQ(exceeded(measures(sum.result(), {0.124, 0.125, 0.24, 0.24})).size(), 3U);
}

TEST(ExceededLimits, ADifferenceOfTheSoftLimitIsNotOverIt) {
  DifferenceSum sum(0.125);
  sum.add(0.125, 0.0);
  sum.end_sample();
  EXPECT_EQ(sum.result().fraction_over_soft, 0.0);
}

}  // namespace
}  // namespace wold::compare
