#pragma once

#include <filesystem>

namespace wold::compare {

enum class FileKind { picture, vdb, df3 };

/// "picture", "vdb" or "df3".
const char* to_string(FileKind kind);

/// OpenVDB files by their first bytes or name, df3 by name, all else is taken for a picture.
/// Throws FileError when there is no such file.
FileKind file_kind(const std::filesystem::path& path);

/// Whether a file's name ends as those of pictures and grids that Wold writes do.
bool is_named_comparable(const std::filesystem::path& path);

}  // namespace wold::compare
