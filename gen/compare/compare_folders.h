#pragma once

#include <vector>

#include "compare/comparison.h"

namespace wold::compare {

/// Compares the pictures, .vdb and .df3 files of two folders and of those in them, by their paths
/// from there. A file that only one folder has is a fault. Evidence goes to a numbered folder for
/// each file. Those that differ come first, else by name. Throws FileError as compare_pair() does
/// and when a folder cannot be read or neither has such a file.
std::vector<Comparison> compare_folders(const std::filesystem::path& got,
                                        const std::filesystem::path& want, const Limits& limits,
                                        const std::filesystem::path& evidence_folder);

}  // namespace wold::compare
