#pragma once

#include <string>
#include <vector>

namespace wold {

/// A file of an archive.
struct ArchivedFile {
  std::string name;  ///< with its folders, as "wold_blender/__init__.py"
  std::string bytes;
};

/// A ZIP archive of these files in this order. The same files make the same bytes anywhere: they
/// are stored as they are, and their times are the format's first day. Throws FileError when the
/// library fails.
std::string zip_archive(const std::vector<ArchivedFile>& files);

}  // namespace wold
