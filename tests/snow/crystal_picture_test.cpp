#include "snow/crystal_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace wold::snow {
namespace {

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

const Image& picture(Crystal crystal, int individual, int level = 0) {
  return pictures()
      .all()[static_cast<std::size_t>(pictures().crystal(crystal, individual, level))]
      .opacity;
}

/// How well a picture agrees with itself turned by an angle: the correlation of their pixels, in
/// blocks of 4 x 4 so that hair-thin things count as much as they cover.
double agreement_turned(const Image& image, double angle) {
  const double side = image.width, step = 0.25;
  double products = 0.0, squares = 0.0, turned_squares = 0.0, sum = 0.0, turned_sum = 0.0;
  int blocks = 0;
  const auto block_mean = [&](double x, double y) {
    double total = 0.0;
    for (double dx = -1.5; dx <= 1.5; dx += 4.0 * step)
      for (double dy = -1.5; dy <= 1.5; dy += 4.0 * step) {
        const int column = std::clamp(static_cast<int>(x + dx), 0, image.width - 1);
        const int row = std::clamp(static_cast<int>(y + dy), 0, image.height - 1);
        total += static_cast<double>(*image.pixel(column, row)) / 16.0;
      }
    return total;
  };
  for (double y = 2.0; y < side; y += 4.0)
    for (double x = 2.0; x < side; x += 4.0) {
      const double east = x - side / 2.0, north = y - side / 2.0;
      if (std::hypot(east, north) > side / 2.0) continue;
      const double one = block_mean(x, y);
      const double two = block_mean(side / 2.0 + std::cos(angle) * east - std::sin(angle) * north,
                                    side / 2.0 + std::sin(angle) * east + std::cos(angle) * north);
      products += one * two;
      squares += one * one;
      turned_squares += two * two;
      sum += one;
      turned_sum += two;
      ++blocks;
    }
  const double covariance = products - sum * turned_sum / blocks;
  return covariance / std::sqrt((squares - sum * sum / blocks) *
                                (turned_squares - turned_sum * turned_sum / blocks));
}

TEST(FlakePictures, HaveNamesOfTheirOwnAndTransparentBorders) {
  std::set<std::string> names;
  for (const CrystalPicture& one : pictures().all()) {
    names.insert(one.name);
    const int last = one.opacity.width - 1;
    ASSERT_EQ(one.opacity.height, last + 1);
    for (int i = 0; i <= last; ++i) {
      ASSERT_EQ(*one.opacity.pixel(i, 0) + *one.opacity.pixel(i, last), 0.0F) << one.name;
      ASSERT_EQ(*one.opacity.pixel(0, i) + *one.opacity.pixel(last, i), 0.0F) << one.name;
    }
    for (const float value : one.opacity.values) ASSERT_TRUE(value >= 0.0F && value <= 1.0F);
  }
  EXPECT_EQ(names.size(), pictures().all().size());
  EXPECT_EQ(names.size(), crystal_kinds * 16 + 2);
}

TEST(FlakePictures, GrowSixfold) {
  const double sixth = std::numbers::pi / 3.0;
  for (const Crystal crystal : {Crystal::plate, Crystal::dendrite})
    for (int individual = 0; individual < FlakePictures::individuals; ++individual) {
      const Image& image = picture(crystal, individual);
      EXPECT_GT(agreement_turned(image, sixth), 0.8) << individual;
      EXPECT_LT(agreement_turned(image, 0.5 * sixth), agreement_turned(image, sixth) - 0.1);
    }
  EXPECT_LT(agreement_turned(picture(Crystal::column, 0), sixth), 0.6);
}

TEST(FlakePictures, LevelsAreAsOpaqueAndHalfAsWide) {
  for (int level = 1; level < FlakePictures::levels; ++level) {
    EXPECT_EQ(picture(Crystal::aggregate, 1, level).width, 128 >> level);
    EXPECT_NEAR(pictures().mean_opacity(pictures().crystal(Crystal::aggregate, 1, level)),
                pictures().mean_opacity(pictures().crystal(Crystal::aggregate, 1, 0)), 1e-5F);
  }
}

TEST(FlakePictures, AreKeyed) {
  EXPECT_EQ(FlakePictures(1).all()[40].opacity.values, pictures().all()[40].opacity.values);
  EXPECT_NE(FlakePictures(2).all()[40].opacity.values, pictures().all()[40].opacity.values);
  EXPECT_NE(picture(Crystal::dendrite, 0).values, picture(Crystal::dendrite, 1).values);
}

}  // namespace
}  // namespace wold::snow
