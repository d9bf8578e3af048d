#include "compare/ssim.h"

#include <gtest/gtest.h>

#include "picture_samples.h"

namespace wold::compare {
namespace {

using test::flat;

TEST(Ssim, OfEqualPicturesIs1) {
  EXPECT_DOUBLE_EQ(ssim(test::waves(1.0, 0.0), test::waves(1.0, 0.0)), 1.0);
}

// Without structure only equation 6, the luminances, is left; single precision leaves 2e-4.
TEST(Ssim, OfFlatPicturesIsThatOfTheirBrightness) {
  for (const auto& [a, b] : {std::pair{0.0F, 1.0F}, {0.25F, 0.5F}, {0.9F, 0.8F}})
    EXPECT_NEAR(ssim(flat(9, 7, {a, a, a}), flat(9, 7, {b, b, b})),
                (2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4), 3e-4);
}

// A wave and its negative about the same grey: covariance is minus the variance.
TEST(Ssim, OfANegativeIsNearMinus1) {
  EXPECT_LT(ssim(test::waves(1.0, 0.0), test::waves(-1.0, 0.0)), -0.5);
}

// Computed from the paper's equation 13 in NumPy, in double precision and with a window of two
// dimensions.
TEST(Ssim, AgreesWithTheFormulaComputedElsewhere) {
  EXPECT_NEAR(ssim(test::waves(1.0, 0.0), test::other_waves()), 0.882753, 1e-5);
}

TEST(Ssim, IsTheSameBothWaysAndMirrored) {
  const auto turned = [](Image image) {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width / 2; ++x)
        std::swap_ranges(image.pixel(x, y), image.pixel(x, y) + 3,
                         image.pixel(image.width - 1 - x, y));
    return image;
  };
  const Image a = test::waves(1.0, 0.0);
  const Image b = test::other_waves();
  EXPECT_EQ(ssim(a, b), ssim(b, a));
  EXPECT_NEAR(ssim(a, b), ssim(turned(a), turned(b)), 1e-6);
}

}  // namespace
}  // namespace wold::compare
