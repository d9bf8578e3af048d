#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wold {

/// A picture in memory: rows from the top, channels interleaved. Values are linear light unless
/// a function says otherwise.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 3;
  std::vector<float> values;

  Image() = default;
  Image(int width_px, int height_px, int channel_count)
      : width(width_px),
        height(height_px),
        channels(channel_count),
        values(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
               static_cast<std::size_t>(channel_count)) {}

  float* pixel(int x, int y) {
    return values.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x)) *
                               static_cast<std::size_t>(channels);
  }
  const float* pixel(int x, int y) const { return const_cast<Image*>(this)->pixel(x, y); }
};

/// How an image is kept on disk.
enum class PixelFormat { uint8, uint16, half, float32 };

/// Writes by extension (.exr, .png, .hdr, .tif), whole or not at all, the same bytes for the same
/// picture. Values are stored as they are: the caller encodes sRGB where it wants it. Throws
/// FileError.
void write_image(const std::filesystem::path& path, const Image& image, PixelFormat format);

/// What a picture's file says of it before its pixels are read.
struct ImageHeader {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::string stored_as;  ///< OpenImageIO's name of the type of its numbers: "uint8", "half" ...
};

/// Throws as read_image() does.
ImageHeader read_image_header(const std::filesystem::path& path);

/// Reads a PNG, JPEG, TIFF, OpenEXR or Radiance HDR picture, whatever its name, values as
/// stored (8 and 16 bit scaled to [0, 1]). Throws FileError when the file is missing, damaged, none
/// of these, deep or of several layers in depth, or has more than 2^28 numbers or 2^17 pixels along
/// a side.
Image read_image(const std::filesystem::path& path);

}  // namespace wold
