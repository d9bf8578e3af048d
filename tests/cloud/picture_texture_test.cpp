#include "cloud/picture_texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "cloud/texture_set.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "support/temporary_folder.h"

namespace wold::cloud {
namespace {

/// A bump in the middle, on grey levels that files of 8 bits keep.
Image bump(int width, int height, int channels) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double dx = (x + 0.5) / width - 0.3, dy = (y + 0.5) / height - 0.5;
      const double value = std::round(255.0 * std::max(0.0, 1.0 - 12.0 * (dx * dx + dy * dy)));
      for (int c = 0; c < channels; ++c) image.pixel(x, y)[c] = static_cast<float>(value / 255.0);
    }
  return image;
}

class Pictures : public testing::TestWithParam<const char*> {};

TEST_P(Pictures, OfAnyFormatGiveTheirLuminance) {
  const test::TemporaryFolder folder("clouds");
  const auto path = folder.path() / (std::string("cloud") + GetParam());
  const bool exr = path.extension() == ".exr";
  write_image(path, bump(40, 30, 3), exr ? PixelFormat::half : PixelFormat::uint8);
  const PeriodicMap<float> opacity = picture_opacity(path, 1024);
  EXPECT_EQ(opacity.width(), 40);
  EXPECT_EQ(opacity.height(), 30);
  EXPECT_NEAR(opacity.at(12, 15), bump(40, 30, 3).pixel(12, 14)[0], 0.03);  // rows from the south
  EXPECT_NEAR(opacity.at(39, 0), 0.0, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Formats, Pictures, testing::Values(".tif", ".png", ".jpg", ".exr"));

TEST(Pictures, PreferTheirAlphaUnlessAllIsOpaque) {
  const test::TemporaryFolder folder("clouds");
  Image image = bump(8, 8, 4);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = 0.0F;
  write_image(folder.path() / "a.exr", image, PixelFormat::half);
  EXPECT_GT(picture_opacity(folder.path() / "a.exr", 1024).at(2, 4), 0.9F);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      image.pixel(x, y)[3] = 1.0F;
      image.pixel(x, y)[1] = std::numeric_limits<float>::quiet_NaN();
    }
  write_image(folder.path() / "b.exr", image, PixelFormat::half);
  EXPECT_EQ(picture_opacity(folder.path() / "b.exr", 1024).at(2, 4), 0.0F);
}

TEST(Pictures, ThatDoNotCloseAreMadeTo) {
  const test::TemporaryFolder folder("clouds");
  Image ramp(64, 16, 1);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x) ramp.pixel(x, y)[0] = static_cast<float>(x) / 63.0F;
  write_image(folder.path() / "ramp.exr", ramp, PixelFormat::float32);
  const PeriodicMap<float> closed = picture_opacity(folder.path() / "ramp.exr", 1024);
  ASSERT_EQ(closed.width(), 56);
  EXPECT_EQ(closed.height(), 16);
  for (int x = 0; x < 56; ++x)
    EXPECT_LT(std::abs(closed.at(x, 3) - closed.wrapped(x - 1, 3)), 0.15F) << x;
}

TEST(Pictures, AreAveragedDownKeepingTheirMean) {
  const test::TemporaryFolder folder("clouds");
  write_image(folder.path() / "a.exr", bump(130, 70, 1), PixelFormat::float32);
  const auto mean = [](const PeriodicMap<float>& map) {
    double sum = 0.0;
    for (const float value : map.values()) sum += value;
    return sum / static_cast<double>(map.values().size());
  };
  const PeriodicMap<float> small = picture_opacity(folder.path() / "a.exr", 32);
  EXPECT_EQ(small.width(), 32);
  EXPECT_EQ(small.height(), 32);
  EXPECT_NEAR(mean(small), mean(picture_opacity(folder.path() / "a.exr", 1024)), 0.01);
}

TEST(Pictures, OfOnePixelAreAVeil) {
  const test::TemporaryFolder folder("clouds");
  Image pixel(1, 1, 1);
  pixel.values[0] = 0.25F;
  write_image(folder.path() / "one.exr", pixel, PixelFormat::float32);
  scene::CloudLayer layer;
  layer.textures = {(folder.path() / "one.exr").string()};
  const TextureSet veil = textures_of(layer, recipe_of(scene::CloudKind::cumulus), 256, 1);
  EXPECT_EQ(veil.profile.front(), 1.0F);
  EXPECT_EQ(veil.cover, 1.0);
  EXPECT_NEAR(veil.densest_opacity, 0.25, 1e-6);
}

std::string failure_of(const std::filesystem::path& path) {
  try {
    picture_opacity(path, 256);
  } catch (const FileError& error) {
    return error.what();
  }
  return "none";
}

TEST(Pictures, ThatAreDamagedOrTooLargeAreNamed) {
  const test::TemporaryFolder folder("clouds");
  const auto path = folder.path() / "cloud.png";
  write_image(path, bump(64, 64, 3), PixelFormat::uint8);
  const std::string whole = read_file(path);
  write_file(path, whole.substr(0, whole.size() / 2));
  EXPECT_THAT(failure_of(path), testing::HasSubstr(path.string()));
  write_file(path, "no picture at all");
  EXPECT_THAT(failure_of(path), testing::HasSubstr(path.string()));
  EXPECT_THAT(failure_of(folder.path() / "none.png"), testing::HasSubstr("none.png"));
  write_image(path, Image(20000, 1, 1), PixelFormat::uint8);
  EXPECT_THAT(failure_of(path), testing::HasSubstr("found 20000 x 1 pixels, expected at most "
                                                   "8192 x 8192"));
}

TEST(Pictures, WithoutAnyCloudAreAClearSky) {
  const test::TemporaryFolder folder("clouds");
  write_image(folder.path() / "black.png", Image(16, 16, 3), PixelFormat::uint8);
  scene::CloudLayer layer;
  layer.textures = {(folder.path() / "black.png").string()};
  const TextureSet clear = textures_of(layer, recipe_of(scene::CloudKind::cumulus), 256, 1);
  EXPECT_EQ(clear.densest_opacity, 0.0);
  EXPECT_EQ(clear.profile.back(), 0.0F);
}

}  // namespace
}  // namespace wold::cloud
