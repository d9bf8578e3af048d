#pragma once

#include <filesystem>
#include <string>

namespace wold {

/// The machine's name; "unknown" when it has none.
std::string host_name();

/// Neighbour of `path` that no other process on any machine uses and that nobody can foresee, with
/// the same extension: ".0001.<host>.<pid>.<24 hexadecimal digits>.tmp.png". A new one with every
/// call. The last eight digits follow from what stands before them: no file of a user's has such a
/// name. Throws FileError when the system gives no random numbers.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Whether a file or folder has such a name and nobody will miss it: its process was this
/// machine's and has ended, or it has not been touched for longer than any task may run. Also what
/// a renderer has put beside one, with another extension. For a process that has made none yet.
bool is_left_behind(const std::filesystem::path& path);

}  // namespace wold
