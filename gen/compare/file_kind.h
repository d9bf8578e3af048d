#pragma once

#include <filesystem>

namespace wold::compare {

enum class FileKind { picture, vdb, df3 };

/// "picture", "vdb" or "df3".
const char* to_string(FileKind kind);

/// OpenVDB files by their first bytes or name, df3 by name, all else is taken for a picture.
/// Throws FileError when there is no such file.
FileKind file_kind(const std::filesystem::path& path);

}  // namespace wold::compare
