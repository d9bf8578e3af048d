#include "core/layered_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

LayeredImage two_layers() {
  return {3,
          2,
          {{"depth.Z", PixelFormat::float32, {1.0F, 2.5F, 1e10F, -3.0F, 0.1F, 6.0F}},
           {"b.X", PixelFormat::half, {0.0F, 0.5F, -1.0F, 2.0F, 1024.0F, 0.25F}}},
          {{"who/what", "a text; with \"signs\""}}};
}

TEST(LayeredImage, ComesBackAsItWas) {
  const test::TemporaryFolder folder("layered");
  const LayeredImage image = two_layers();
  write_layered_image(folder.path() / "a.exr", image);
  const LayeredImage read = read_layered_image(folder.path() / "a.exr");
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  ASSERT_EQ(read.channels.size(), 2U);
  for (const ImageChannel& channel : image.channels) {
    ASSERT_TRUE(read.find(channel.name)) << channel.name;
    EXPECT_EQ(read.find(channel.name)->values, channel.values) << channel.name;
    EXPECT_EQ(read.find(channel.name)->stored_as, channel.stored_as) << channel.name;
  }
  EXPECT_EQ(read.attributes.at("who/what"), image.attributes.at("who/what"));
  EXPECT_FALSE(read.find("depth.A"));
}

TEST(LayeredImage, TheSamePictureIsTheSameBytes) {
  const test::TemporaryFolder folder("layered_bytes");
  write_layered_image(folder.path() / "a.exr", two_layers());
  write_layered_image(folder.path() / "b.exr", two_layers());
  EXPECT_EQ(read_file(folder.path() / "a.exr"), read_file(folder.path() / "b.exr"));
}

TEST(LayeredImage, IsWrittenWholeOrNotAtAll) {
  const test::TemporaryFolder folder("layered_missing");
  EXPECT_THROW(write_layered_image(folder.path() / "no" / "a.exr", two_layers()), FileError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LayeredImage, DamagedFilesAreRefused) {
  const test::TemporaryFolder folder("layered_damaged");
  const std::filesystem::path file = folder.path() / "a.exr";
  EXPECT_THROW(read_layered_image(file), FileError);
  write_layered_image(file, two_layers());
  const std::string bytes = read_file(file);
  for (std::size_t size = 0; size + 1 < bytes.size(); size += 7) {
    write_file(file, bytes.substr(0, size));
    EXPECT_THROW(read_layered_image(file), FileError) << size;
  }
}

}  // namespace
}  // namespace wold
