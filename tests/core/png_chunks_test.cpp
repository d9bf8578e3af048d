#include "core/png_chunks.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

const std::string signature("\x89PNG\r\n\x1a\n");

/// Of up to 255 bytes, with some checksum.
std::string chunk(const std::string& type, const std::string& data) {
  return std::string(3, '\0') + static_cast<char>(data.size()) + type + data + "1234";
}

TEST(PngChunks, ThePictureAloneStays) {
  const std::string header = chunk("IHDR", "size");
  const std::string picture = chunk("PLTE", "") + chunk("IDAT", "pixels") + chunk("IDAT", "more");
  const std::string end = chunk("IEND", "");
  EXPECT_EQ(without_ancillary_chunks(signature + header + chunk("gAMA", "x") + chunk("eXIf", "") +
                                     picture + chunk("tEXt", "IDAT") + end),
            signature + header + picture + end);
}

TEST(PngChunks, WhatIsCutOffIsRefused) {
  const std::string whole = signature + chunk("IHDR", "size") + chunk("IEND", "");
  EXPECT_EQ(without_ancillary_chunks(whole), whole);
  for (const std::size_t length : {whole.size() - 1, whole.size() - 11, std::size_t{3}})
    EXPECT_THROW(without_ancillary_chunks(whole.substr(0, length)), FileError) << length;
}

TEST(PngChunks, WrittenPicturesHaveNoOthers) {
  const test::TemporaryFolder folder{"png"};
  const auto file = folder.path() / "a.png";
  Image image(5, 3, 3);
  image.pixel(2, 1)[1] = 1.0F;
  write_image(file, image, PixelFormat::uint8);
  const std::string bytes = read_file(file);
  EXPECT_EQ(without_ancillary_chunks(bytes), bytes);
  EXPECT_EQ(read_image(file).values, image.values);
}

}  // namespace
}  // namespace wold
