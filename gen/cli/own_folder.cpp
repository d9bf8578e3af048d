#include "cli/own_folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace wold::cli {
namespace fs = std::filesystem;
namespace {

bool is_within(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

void require_no_way_out(const fs::path& folder) {
  std::error_code error;
  const fs::path own = fs::canonical(folder, error);
  if (error) return;  // making it tells why
  fs::recursive_directory_iterator entry(own, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code unknown;
    if (!entry->is_symlink(unknown)) continue;
    const fs::path target = fs::weakly_canonical(entry->path(), unknown);
    if (unknown || !is_within(target, own))
      throw FileError(
          fmt::format("{} is a link that leads out of the output folder, to {}: remove it, or "
                      "choose another folder (--out)",
                      entry->path().string(), target.string()));
  }
}

}  // namespace wold::cli
