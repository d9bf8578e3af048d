#include "compare/compare_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compare/compare_pair.h"
#include "compare/picture_pair.h"
#include "core/error.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

/// Of the files that can be compared, from the folder.
std::set<fs::path> names_below(const fs::path& folder) {
  std::set<fs::path> names;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && is_named_comparable(entry.path()))
        names.insert(entry.path().lexically_relative(folder));
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("cannot read {}: {}", folder.string(), error.code().message()));
  }
  return names;
}

/// What stands for a file that only one of the folders has.
Comparison unpaired(const fs::path& file, bool is_got, const fs::path& evidence_folder) {
  Comparison result;
  const FileKind kind = file_kind(file);
  result.kind = to_string(kind);
  (is_got ? result.got : result.want) = file;
  result.faults.emplace_back(is_got ? "is new: nothing is wanted" : "is missing");
  if (kind == FileKind::picture && !evidence_folder.empty())
    result.evidence.push_back(shown_picture(evidence_folder, is_got ? "got" : "want",
                                            is_got ? "got.png" : "want.png", read_image(file)));
  return result;
}

fs::path numbered(const fs::path& folder, std::size_t number) {
  return folder.empty() ? folder : folder / fmt::format("{:04}", number);
}

}  // namespace

std::vector<Comparison> compare_folders(const fs::path& got, const fs::path& want,
                                        const Limits& limits, const fs::path& evidence_folder) {
  const std::set<fs::path> got_names = names_below(got);
  std::set<fs::path> names = names_below(want);
  const std::set<fs::path> want_names = names;
  names.insert(got_names.begin(), got_names.end());
  if (names.empty())
    throw FileError(fmt::format("there are no pictures, .vdb or .df3 files in {} and {}",
                                got.string(), want.string()));
  std::vector<Comparison> list;
  for (const fs::path& name : names) {
    const fs::path evidence = numbered(evidence_folder, list.size() + 1);
    const bool is_got = got_names.contains(name);
    list.push_back(is_got && want_names.contains(name)
                       ? compare_pair(got / name, want / name, limits, evidence)
                       : unpaired((is_got ? got : want) / name, is_got, evidence));
    list.back().name = name.string();
  }
  std::stable_partition(list.begin(), list.end(),
                        [](const Comparison& one) { return !is_same(one); });
  return list;
}

}  // namespace wold::compare
