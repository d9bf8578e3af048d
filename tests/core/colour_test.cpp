#include "core/colour.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace wold {
namespace {

void expect_near(const glm::dvec3& got, const glm::dvec3& want, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], tolerance) << "channel " << i;
}

TEST(Colour, WhiteAndPrimariesAreThoseOfTheStandard) {
  expect_near(xyz_from_srgb(glm::dvec3(1.0)), {0.9505, 1.0, 1.0890}, 1e-4);
  // IEC 61966-2-1: chromaticities of red, green and blue.
  const std::array<glm::dvec2, 3> primaries = {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 rgb(0.0);
    rgb[i] = 1.0;
    const glm::dvec3 xyz = xyz_from_srgb(rgb);
    EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), primaries[static_cast<std::size_t>(i)].x, 1e-3);
    EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), primaries[static_cast<std::size_t>(i)].y, 1e-3);
    EXPECT_NEAR(xyz.y, luminance(rgb), 1e-4);
  }
}

TEST(Colour, LabOfWhiteGreyAndBlack) {
  const glm::dvec3 white = xyz_from_srgb(glm::dvec3(1.0));
  EXPECT_NEAR(glm::distance(lab_from_xyz(white), {100.0, 0.0, 0.0}), 0.0, 1e-9);
  EXPECT_NEAR(lab_from_xyz(0.184187 * white).x, 50.0, 1e-4);  // ((50 + 16) / 116)^3
  EXPECT_NEAR(lab_from_xyz(0.001 * white).x, 0.9033, 1e-4);   // the linear foot: Y * 24389 / 27
  EXPECT_NEAR(glm::length(lab_from_xyz(glm::dvec3(0.0))), 0.0, 1e-9);
}

TEST(Colour, TransferFunctionHasTheStandardsValuesAndInverse) {
  EXPECT_NEAR(srgb_encoded(0.18), 0.461356, 1e-6);
  EXPECT_NEAR(srgb_decoded(128.0 / 255.0), 0.215861, 1e-6);
  EXPECT_DOUBLE_EQ(srgb_encoded(0.001), 0.01292);
  EXPECT_NEAR(srgb_encoded(1.0), 1.0, 1e-15);
  for (int i = 0; i <= 255; ++i)
    EXPECT_NEAR(srgb_encoded(srgb_decoded(i / 255.0)), i / 255.0, 1e-7);
}

TEST(Colour, GamutKeepsLuminanceAndWhatIsInside) {
  const glm::dvec3 inside(0.2, 0.5, 0.9);
  EXPECT_EQ(in_gamut(inside), inside);
  for (const glm::dvec3& outside : {glm::dvec3(1.159, 0.687, 0.082), glm::dvec3(0.1, 0.3, -0.05)}) {
    const glm::dvec3 got = in_gamut(outside, 0.99);
    EXPECT_NEAR(luminance(got), luminance(outside), 1e-12);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(got[i], 0.0);
      EXPECT_LE(got[i], 0.99);
    }
  }
  EXPECT_EQ(in_gamut({3.0, 2.0, 1.5}, 0.99), glm::dvec3(0.99));
  EXPECT_EQ(in_gamut({-1.0, -0.2, 0.0}), glm::dvec3(0.0));
}

TEST(Colour, ObserverWeighsByIlluminantAndMatchingFunctions) {
  const std::array<glm::dvec3, 2> matching = {{{0.4, 0.3, 0.0}, {0.1, 0.2, 0.9}}};
  const std::array<double, 2> illuminant = {2.0, 1.0};
  const Observer observer(matching, illuminant);
  expect_near(observer.xyz(std::array{1.0, 1.0}), {0.9 / 0.8, 1.0, 0.9 / 0.8}, 1e-15);
  expect_near(observer.xyz(std::array{0.5, 0.0}), {0.4 / 0.8, 0.3 / 0.8, 0.0}, 1e-15);
  expect_near(observer.linear_srgb(std::array{1.0, 1.0}), glm::dvec3(1.0), 1e-15);
  EXPECT_THROW(observer.xyz(std::array{1.0}), std::invalid_argument);
  EXPECT_THROW(Observer(matching, std::array{1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace wold
