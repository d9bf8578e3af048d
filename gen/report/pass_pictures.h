#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wold::report {

/// One pass of a frame as a picture for people.
struct PassPicture {
  std::string name;      ///< "depth"
  std::string data_uri;  ///< of a JPEG
};

/// The passes in a file of `wold passes`, shrunk to thumbnails. Numbers are grey, from the least in
/// the picture, black, to the largest, white; what is nothing is black. Normals, positions and
/// motion have their axes as red, green and blue, and colours are as bright as the brightest
/// allows. Ids have a colour of their own each. None of a file that is missing, damaged or without
/// layers.
std::vector<PassPicture> pass_pictures(const std::filesystem::path& file);

}  // namespace wold::report
