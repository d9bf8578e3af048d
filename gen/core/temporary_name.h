#pragma once

#include <filesystem>
#include <string>

namespace wold {

/// The machine's name; "unknown" when it has none.
std::string host_name();

/// Neighbour of `path` that no other process on any machine uses, with the same extension:
/// ".0001.<host>.<pid>.tmp.png".
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Whether a file has such a name; also what a renderer has put beside one, with another extension.
bool is_temporary_name(const std::filesystem::path& path);

}  // namespace wold
