#include "core/file_list.h"

#include <algorithm>

#include "core/temporary_name.h"

namespace wold {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> all_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; at != end; at.increment(error))
    if (std::error_code gone; at->is_regular_file(gone)) files.push_back(at->path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files = all_files(folder);
  std::erase_if(files,
                [](const fs::path& file) { return file.filename().string().front() == '.'; });
  return files;
}

void remove_temporaries(const fs::path& folder) {
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; at != end; at.increment(error))
    if (is_left_behind(at->path())) left.push_back(at->path());
  for (const fs::path& path : left) fs::remove_all(path);
}

}  // namespace wold
