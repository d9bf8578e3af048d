#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wold::compare {

/// What is in a file and what is wrong with it.
struct Inspection {
  std::vector<std::string> problems;  ///< empty for a sound file
  std::string text;                   ///< "key: value" lines for people
  std::string json;                   ///< the same with keys in a fixed order
};

/// Looks into a picture, .vdb or .df3: kind, bytes on disk, size, value range, memory once loaded,
/// metadata, problems. A damaged file is described as far as possible, with the damage among the
/// problems. Throws FileError when there is no such file.
Inspection inspect(const std::filesystem::path& path);

}  // namespace wold::compare
