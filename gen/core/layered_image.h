#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/image.h"

namespace wold {

/// One channel of a picture of many: rows from the top.
struct ImageChannel {
  std::string name;                              ///< "<layer>.<letter>", such as "depth.Z"
  PixelFormat stored_as = PixelFormat::float32;  ///< half or float32
  std::vector<float> values;
};

/// A picture of any number of named channels, and what its file says of them.
struct LayeredImage {
  int width = 0;
  int height = 0;
  std::vector<ImageChannel> channels;             ///< each name once
  std::map<std::string, std::string> attributes;  ///< of the file's header

  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// The channel of that name; nullptr where there is none.
  const ImageChannel* find(const std::string& name) const;
};

/// Writes an OpenEXR file of one part, whole or not at all, the same bytes for the same picture.
/// Throws FileError.
void write_layered_image(const std::filesystem::path& path, const LayeredImage& image);

/// Reads an OpenEXR file of one part with its channels by name, in the file's order, and the
/// attributes of its header that are text. Throws FileError as read_image() does.
LayeredImage read_layered_image(const std::filesystem::path& path);

}  // namespace wold
