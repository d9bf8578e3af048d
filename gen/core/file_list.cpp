#include "core/file_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
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

std::vector<fs::path> programs_below(const fs::path& folder) {
  std::vector<fs::path> files = files_below(folder);
  std::erase_if(
      files, [](const fs::path& file) { return file.parent_path().filename() == "__pycache__"; });
  return files;
}

std::string hash_of_programs_below(const fs::path& folder) {
  std::string text;
  for (const fs::path& file : programs_below(folder))
    text += fmt::format("{} {}\n", file.lexically_relative(folder).string(),
                        content_hash(read_file(file)));
  return content_hash(text);
}

void remove_temporaries(const fs::path& folder) {
  constexpr auto options = fs::directory_options::skip_permission_denied;
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, options, error), end; at != end;
       at.increment(error))
    if (is_left_behind(at->path())) left.push_back(at->path());
  for (const fs::path& path : left) fs::remove_all(path, error);
}

}  // namespace wold
