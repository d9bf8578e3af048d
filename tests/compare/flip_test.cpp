#include "compare/flip.h"

#include <gtest/gtest.h>

#include <limits>

#include "compare/pixels.h"
#include "picture_samples.h"

namespace wold::compare {
namespace {

using test::flat;

double flip(const Image& got, const Image& want) { return mean(flip_map(got, want)); }

TEST(Flip, OfEqualPicturesIs0) {
  EXPECT_EQ(flip(test::waves(1.0, 0.0), test::waves(1.0, 0.0)), 0.0);
}

// The paper scales differences by that of green and blue.
TEST(Flip, OfGreenAndBlueIs1) {
  EXPECT_NEAR(flip(flat(9, 7, {0, 1, 0}), flat(9, 7, {0, 0, 1})), 1.0, 1e-5);
}

TEST(Flip, OfBlackAndWhiteIsWhatTheFormulasGive) {
  // L* is 100 apart. Green is (87.73, -86.18, 83.18) in L*a*b*, blue (32.30, 79.19, -107.86)
  // (Lindbloom, D65); a* and b* times L* / 100, their HyAB distance is the largest.
  const double largest =
      std::pow(87.73 - 32.30 +
                   std::hypot(0.8773 * -86.18 - 0.3230 * 79.19, 0.8773 * 83.18 - 0.3230 * -107.86),
               0.7);
  const double fraction = std::pow(100.0, 0.7) / largest;
  EXPECT_NEAR(flip(flat(9, 7, {0, 0, 0}), flat(9, 7, {1, 1, 1})),
              0.95 + 0.05 * (fraction - 0.4) / 0.6, 1e-4);
}

// What the authors' own program, FLIP.h 1.7, gives for these pictures.
TEST(Flip, AgreesWithItsAuthorsProgram) {
  const Image want = test::waves(1.0, 0.0);
  const Image map = flip_map(test::other_waves(), want);
  EXPECT_NEAR(mean(map), 0.519533, 5e-4);
  EXPECT_NEAR(*map.pixel(21, 21), 0.971458, 5e-4);
  EXPECT_NEAR(*map.pixel(40, 10), 0.529618, 5e-4);
  EXPECT_NEAR(mean(flip_map(test::other_waves(), want, 30.0)), 0.525456, 5e-4);
}

TEST(Flip, IsTheSameBothWaysTurnedAndMirrored) {
  const auto mirrored = [](Image image) {
    std::reverse(image.values.begin(), image.values.end());  // half a turn, red and blue swapped
    for (std::size_t i = 0; i < image.values.size(); i += 3)
      std::swap(image.values[i], image.values[i + 2]);
    return image;
  };
  const Image a = test::waves(1.0, 0.0);
  const Image b = test::other_waves();
  EXPECT_EQ(flip(a, b), flip(b, a));
  EXPECT_NEAR(flip(a, b), flip(mirrored(a), mirrored(b)), 1e-6);
}

TEST(Flip, DetailBeyondTheEyeCountsLessFromFarAway) {
  Image checks(32, 32, 3);
  for (int i = 0; i < 32 * 32; ++i)
    std::fill_n(checks.pixel(i % 32, i / 32), 3, (i + i / 32) % 2 == 0 ? 0.6F : 0.4F);
  const Image grey = flat(32, 32, {0.51F, 0.51F, 0.51F});
  EXPECT_LT(mean(flip_map(checks, grey, 120.0)), 0.2 * mean(flip_map(checks, grey, 10.0)));
}

TEST(Flip, TakesGreysAlphaAndNoNumbers) {
  EXPECT_EQ(flip(flat(8, 8, {0.5F}), flat(8, 8, {0.5F, 0.5F, 0.5F, 0.1F})), 0.0);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(flip(flat(8, 8, {nan, 9.0F, -1.0F}), flat(8, 8, {0.0F, 1.0F, 0.0F})), 0.0);
}

}  // namespace
}  // namespace wold::compare
