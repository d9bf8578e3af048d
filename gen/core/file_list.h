#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wold {

/// Every file below a folder by its whole path, in a fixed order; none when there is no such
/// folder. Files whose names start with a dot are left out: temporary ones. One that goes
/// meanwhile, because another process renames it, is no error.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// The same without the byte code that Python keeps beside programs: what the programs are.
std::vector<std::filesystem::path> programs_below(const std::filesystem::path& folder);

/// Hash of the names and bytes of all of programs_below(). Throws FileError.
std::string hash_of_programs_below(const std::filesystem::path& folder);

/// Removes what processes that were killed have left below a folder under temporary names, files
/// and folders; see is_left_behind(). What may not be removed, because it is another user's, stays.
void remove_temporaries(const std::filesystem::path& folder);

}  // namespace wold
