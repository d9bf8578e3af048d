#pragma once

#include <filesystem>
#include <string>

#include "core/image.h"

namespace wold {

/// How a picture is kept in a page: at most that wide, as JPEG.
struct PagePicture {
  int widest_px = 960;
  int quality = 80;  ///< of JPEG, [1, 100]
};

/// The bytes of a JPEG file of a picture in 8-bit colours, shrunk where it is wider. Its values are
/// those that are shown, from 0 to 1. Throws FileError.
std::string jpeg_of(Image picture, const PagePicture& form);

/// The same of a picture's file. Throws FileError when it is missing or damaged.
std::string jpeg_of(const std::filesystem::path& picture, const PagePicture& form);

/// "data:<type>;base64,...": a file inside a page. `type` is a media type, such as "image/jpeg".
std::string data_uri(const std::string& type, const std::string& bytes);

}  // namespace wold
