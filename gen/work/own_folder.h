#pragma once

#include <filesystem>
#include <span>

namespace wold::work {

/// Refuses a folder as output folder in which something lies and that no run of this program has
/// made: what lies there may be a user's own. A run leaves its record: the lock, the format or a
/// record in `tasks`, or manifest.json. Neither what other commands put there before (preview.png,
/// report.html, logs/slurm) nor hidden files count. A folder that is not there is nobody's. Throws
/// InputError.
void require_own_folder(const std::filesystem::path& folder);

/// Whether it is a list of files as `render` writes it, and not a user's file of that name.
bool is_own_manifest(const std::filesystem::path& file);

/// Refuses an output folder in which a link leads out of it: through a stranger's folder nothing
/// elsewhere is to be written, removed or locked. Throws FileError that names the link and where it
/// leads.
void require_no_way_out(const std::filesystem::path& folder);

/// The same of these folders below it alone, named relative to it, and of those that they lie in:
/// for a task, which must not look through all of a film. A folder that is not there leads nowhere.
void require_no_way_out(const std::filesystem::path& folder,
                        std::span<const std::filesystem::path> below);

}  // namespace wold::work
