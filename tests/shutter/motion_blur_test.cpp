#include "shutter/motion_blur.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wold::shutter {
namespace {

using Colour = std::function<float(int x, int y)>;
using Motion = std::function<glm::vec2(int x, int y)>;

constexpr int width = 96, height = 54;

Image picture_of(const Colour& colour) {
  Image picture(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) *picture.pixel(x, y) = colour(x, y);
  return picture;
}

MotionField field_of(const Motion& motion, const Colour& depth_m) {
  MotionField field{width, height, {}, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      field.motion_px.push_back(motion(x, y));
      field.depth_m.push_back(depth_m(x, y));
    }
  return field;
}

float depth_of_all(int, int) { return 10.0F; }

/// For what share of the time that a shutter is open for a place within [begin, end) stands at x,
/// moving straight by `motion_px` a frame.
double share_within(double x, double begin, double end, double motion_px, double shutter) {
  const double half = 0.5 * shutter * std::abs(motion_px);
  return std::max(0.0, std::min(x + half, end) - std::max(x - half, begin)) / (2.0 * half);
}

/// Root mean square of the difference, but for the margin that what comes into view may reach.
double rms_inside(const Image& a, const Image& b, int margin_px) {
  double sum = 0.0;
  for (int y = 0; y < height - margin_px; ++y)
    for (int x = margin_px; x < width - margin_px; ++x)
      sum += std::pow(double{*a.pixel(x, y)} - double{*b.pixel(x, y)}, 2.0);
  return std::sqrt(sum / ((width - 2 * margin_px) * (height - margin_px)));
}

TEST(MotionBlur, WhatStandsStillStaysAsItIs) {
  const Image picture = picture_of([](int x, int y) { return 0.01F * static_cast<float>(x ^ y); });
  const MotionField still = field_of([](int, int) { return glm::vec2(0.0F); }, depth_of_all);
  EXPECT_EQ(motion_blurred(picture, still, 1.0).values, picture.values);
  const MotionField moving = field_of([](int, int) { return glm::vec2(7.0F, 3.0F); }, depth_of_all);
  EXPECT_EQ(motion_blurred(picture, moving, 0.0).values, picture.values);
}

TEST(MotionBlur, AnEdgeBecomesARampAsLongAsTheMotion) {
  for (const double shutter : {0.5, 1.0}) {
    const Image picture = picture_of([](int x, int) { return x < 48 ? 1.0F : 0.0F; });
    const MotionField field =
        field_of([](int, int) { return glm::vec2(-12.0F, 0.0F); }, depth_of_all);
    const Image blurred = motion_blurred(picture, field, shutter);
    for (int x = 0; x < width; ++x)
      EXPECT_NEAR(*blurred.pixel(x, 20), share_within(x, -1e3, 47.5, 12.0, shutter), 0.05)
          << x << ", shutter " << shutter;
  }
}

TEST(MotionBlur, AMovingThingHidesAndShowsWhatIsBehindIt) {
  const auto is_thing = [](int x, int y) { return x >= 40 && x < 60 && y >= 10 && y < 40; };
  const Image picture = picture_of([&](int x, int y) { return is_thing(x, y) ? 1.0F : 0.1F; });
  const MotionField field = field_of(
      [&](int x, int y) { return is_thing(x, y) ? glm::vec2(14.0F, 0.0F) : glm::vec2(0.0F); },
      [&](int x, int y) { return is_thing(x, y) ? 3.0F : 50.0F; });
  const Image blurred = motion_blurred(picture, field, 1.0);
  for (int x = 0; x < width; ++x) {
    EXPECT_NEAR(*blurred.pixel(x, 20), 0.1 + 0.9 * share_within(x, 39.5, 59.5, 14.0, 1.0), 0.07)
        << x;
    EXPECT_NEAR(*blurred.pixel(x, 45), 0.1F, 1e-6F) << x;
  }
}

TEST(MotionBlur, AThingAtRestStaysSharpBeforeWhatMoves) {
  const auto is_thing = [](int x, int) { return x >= 40 && x < 60; };
  const Image picture = picture_of([&](int x, int) {
    return is_thing(x, 0) ? 1.0F : 0.3F + 0.2F * static_cast<float>(x / 4 % 2);
  });
  const MotionField field = field_of(
      [&](int x, int y) { return is_thing(x, y) ? glm::vec2(0.0F) : glm::vec2(9.0F, 0.0F); },
      [&](int x, int y) { return is_thing(x, y) ? 3.0F : 50.0F; });
  const Image blurred = motion_blurred(picture, field, 0.8);
  for (int x = 40; x < 60; ++x) EXPECT_NEAR(*blurred.pixel(x, 20), 1.0F, 1e-5F) << x;
  for (int x = 10; x < 30; ++x) EXPECT_NEAR(*blurred.pixel(x, 20), 0.4F, 0.06F) << x;
}

/// A plain with a pattern that fades far off, from 1.5 m above, seen by a camera that goes aside
/// and ahead.
class Plain {
 public:
  static double depth_m(int y) { return y > horizon ? eye_m * focal_px / (y - horizon) : 1e10; }

  /// After so many frames.
  static double seen(int x, int y, double frames) {
    if (y <= horizon) return 0.6;
    const double ahead_m = depth_m(y), right_m = (x - middle) / focal_px * ahead_m;
    return 0.5 + 0.4 * std::exp(-0.25 * ahead_m) * std::sin(9.0 * (right_m + aside_m * frames)) *
                     std::cos(2.0 * (ahead_m + onward_m * frames));
  }
  static glm::vec2 motion_px(int x, int y) {
    if (y <= horizon) return glm::vec2(0.0F);
    const double next_m = depth_m(y) - onward_m;
    const double right_m = (x - middle) / focal_px * depth_m(y) - aside_m;
    return glm::vec2(middle + focal_px * right_m / next_m - x,
                     horizon + focal_px * eye_m / next_m - y);
  }

 private:
  static constexpr double eye_m = 1.5, focal_px = 90.0, horizon = 10.5, middle = 0.5 * width;
  static constexpr double aside_m = 0.8, onward_m = 0.2;  // in each frame
};

TEST(MotionBlur, ADollyIsTheMeanOfItsMoments) {
  constexpr double shutter = 0.5;
  constexpr int moments = 64;
  const Image sharp =
      picture_of([](int x, int y) { return static_cast<float>(Plain::seen(x, y, 0.0)); });
  const Image mean = picture_of([](int x, int y) {
    double sum = 0.0;
    for (int i = 0; i < moments; ++i)
      sum += Plain::seen(x, y, shutter * ((i + 0.5) / moments - 0.5));
    return static_cast<float>(sum / moments);
  });
  const MotionField field =
      field_of(Plain::motion_px, [](int, int y) { return static_cast<float>(Plain::depth_m(y)); });
  const double sharp_off = rms_inside(sharp, mean, 10);
  const double blurred_off = rms_inside(motion_blurred(sharp, field, shutter), mean, 10);
  EXPECT_GT(sharp_off, 0.015);
  EXPECT_LT(blurred_off, 0.15 * sharp_off) << blurred_off;
}

TEST(MotionBlur, HasColoursOfThePictureForAnyMotion) {
  const Image picture = picture_of([](int x, int) { return x % 2 == 0 ? 0.25F : 0.75F; });
  for (const float motion_px : {1e6F, 3e38F, -3e38F}) {
    const MotionField field = field_of(
        [&](int x, int y) {
          return y % 3 == 0 ? glm::vec2(motion_px, -motion_px) : glm::vec2(x, y);
        },
        depth_of_all);
    for (const float value : motion_blurred(picture, field, 1.0).values) {
      ASSERT_GT(value, 0.2499F);
      ASSERT_LT(value, 0.7501F);
    }
  }
}

TEST(MotionBlur, RefusesMotionsOfAnotherSize) {
  EXPECT_THROW(
      motion_blurred(Image(8, 8, 3),
                     field_of([](int, int) { return glm::vec2(0.0F); }, depth_of_all), 0.5),
      std::invalid_argument);
}

}  // namespace
}  // namespace wold::shutter
