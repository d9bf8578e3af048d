#include "report/pass_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "core/files.h"
#include "core/image.h"
#include "core/layered_image.h"
#include "support/temporary_folder.h"

namespace wold::report {
namespace {

/// Near and far ground of two species, and a pixel where nothing is.
LayeredImage three_pixels() {
  LayeredImage image;
  image.width = 3;
  image.height = 1;
  const auto id = [](std::uint32_t bits) { return std::bit_cast<float>(bits); };
  image.channels = {{"depth.A", PixelFormat::half, {1, 1, 0}},
                    {"depth.Z", PixelFormat::float32, {2, 12, 1e10F}},
                    {"species00.R", PixelFormat::float32, {id(0x3f800001), id(0x40000003), 0}},
                    {"species00.G", PixelFormat::float32, {1, 1, 0}},
                    {"species01.R", PixelFormat::float32, {0, 0, 0}},
                    {"albedo.R", PixelFormat::half, {0.1F, 0.2F, 0}},
                    {"albedo.G", PixelFormat::half, {0.1F, 0.1F, 0}},
                    {"albedo.B", PixelFormat::half, {0.1F, 0.0F, 0}}};
  return image;
}

/// A picture in a page, back as values from 0 to 1.
Image decoded(const PassPicture& picture, const std::filesystem::path& folder) {
  const std::string start = "data:image/jpeg;base64,";
  EXPECT_EQ(picture.data_uri.substr(0, start.size()), start);
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : picture.data_uri.substr(start.size())) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(digits.find(c));
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  write_file(folder / "thumbnail.jpg", bytes);
  return read_image(folder / "thumbnail.jpg");
}

TEST(PassPictures, AreOfEachPassInItsOrder) {
  const test::TemporaryFolder folder("pass_pictures");
  write_layered_image(folder.path() / "p.exr", three_pixels());
  std::vector<std::string> names;
  for (const PassPicture& picture : pass_pictures(folder.path() / "p.exr"))
    names.push_back(picture.name);
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"albedo", "depth", "species"}));
}

TEST(PassPictures, SpanBlackToWhiteAndColourIdsApart) {
  const test::TemporaryFolder folder("pass_pictures");
  write_layered_image(folder.path() / "p.exr", three_pixels());
  for (const PassPicture& picture : pass_pictures(folder.path() / "p.exr")) {
    const Image shown = decoded(picture, folder.path());
    ASSERT_EQ(shown.width, 3);
    const auto brightness = [&](int x) {
      const float* rgb = shown.pixel(x, 0);
      return (rgb[0] + rgb[1] + rgb[2]) / 3.0F;
    };
    EXPECT_LT(brightness(2), 0.15F) << picture.name << ": where nothing is";
    if (picture.name == "species")
      EXPECT_GT(brightness(0), 0.2F);
    else
      EXPECT_LT(brightness(0), brightness(1) + 0.1F) << picture.name;
    EXPECT_TRUE(picture.name != "depth" || brightness(1) > 0.85F);
  }
}

TEST(PassPictures, OfADamagedFileThereAreNone) {
  const test::TemporaryFolder folder("pass_pictures");
  write_file(folder.path() / "p.exr", "no picture");
  EXPECT_TRUE(pass_pictures(folder.path() / "p.exr").empty());
  EXPECT_TRUE(pass_pictures(folder.path() / "missing.exr").empty());
}

}  // namespace
}  // namespace wold::report
