#pragma once

#include <filesystem>

namespace wold::work {

/// What the files of an output folder are called and what its records say, as a number. It rises
/// when an older version of the program could not go on with a folder, or would misread it.
inline constexpr int folder_format = 1;

/// Writes `out`/tasks/format.json, the number and the version of the program, unless it says so
/// already. Throws FileError.
void write_folder_format(const std::filesystem::path& out);

/// Refuses an output folder of another format. One that has no number, or a damaged one, is of
/// format 1: the number came after it. Throws InputError that names both numbers, the version that
/// made the folder, and what to do.
void require_known_format(const std::filesystem::path& out);

}  // namespace wold::work
