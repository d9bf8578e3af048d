#include "compare/compare_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "compare/compare_folders.h"
#include "compare/compare_pair.h"
#include "compare/report_page.h"
#include "core/files.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

std::string text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json folders_json(const fs::path& got, const fs::path& want,
                  const std::vector<Comparison>& comparisons, const Limits& limits) {
  Json json = {{"got", got.string()}, {"want", want.string()}};
  json["same"] = std::ranges::all_of(comparisons, is_same);
  json["files"] = Json::array();
  for (const Comparison& comparison : comparisons)
    json["files"].push_back(to_json(comparison, limits));
  return json;
}

Verdict verdict(const std::vector<Comparison>& comparisons, const Json& metrics) {
  Json json = {{"version", 1}};
  json.update(metrics);
  Verdict result;
  result.code = std::ranges::all_of(comparisons, is_same) ? ExitCode::done : ExitCode::different;
  result.json = text(json);
  std::vector<std::string> lines;
  std::ranges::transform(comparisons, std::back_inserter(lines), to_line);
  result.lines = fmt::format("{}", fmt::join(lines, "\n"));
  return result;
}

bool is_same_place(const fs::path& a, const fs::path& b) {
  std::error_code missing;
  return fs::equivalent(a, b, missing);
}

/// Whether a path is a folder or lies in it, at any depth.
bool is_in(const fs::path& path, const fs::path& folder) {
  std::error_code unknown;
  const fs::path inner = fs::weakly_canonical(path, unknown);
  const fs::path outer = fs::weakly_canonical(folder, unknown);
  return !outer.empty() &&
         std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

/// Whether a report that was written before lies in the folder.
bool has_report(const fs::path& folder) {
  const fs::path page = folder / "index.html";
  return why_no_regular_file(page).empty() && is_report_page(read_file(page));
}

/// What stands in the folder where a report has a picture or its page; empty when nothing does.
fs::path in_the_way(const fs::path& folder) {
  for (const char* name :
       {"index.html", "metrics.json", "got.png", "want.png", "difference.png", "flip.png", "0001"})
    if (std::error_code unknown; fs::exists(fs::symlink_status(folder / name, unknown)))
      return folder / name;
  return {};
}

/// A report must replace neither what is compared nor what is not a report's.
void require_free(const fs::path& folder, const fs::path& got, const fs::path& want) {
  std::error_code missing;
  for (const fs::path& input : {got, want})
    for (const char* name : {"got.png", "want.png", "difference.png", "flip.png"})
      if (is_same_place(folder / name, input) ||
          (fs::is_directory(input, missing) && is_in(folder, input)))
        throw InputError(fmt::format(
            "--report: found {}, where {} lies, which is compared; expected another folder",
            folder.string(), input.string()));
  if (const fs::path other = in_the_way(folder); !other.empty() && !has_report(folder))
    throw InputError(fmt::format(
        "--report: found {}, which is not of a report and would be replaced; expected another "
        "folder",
        other.string()));
}

}  // namespace

Verdict compare_paths(const fs::path& got, const fs::path& want, const Limits& limits,
                      const fs::path& report_folder) {
  std::error_code ignored;
  const bool are_folders = fs::is_directory(got, ignored);
  if (are_folders != fs::is_directory(want, ignored))
    throw InputError(fmt::format("{} is {}, {} is {}: two files or two folders are expected",
                                 got.string(), are_folders ? "a folder" : "none", want.string(),
                                 are_folders ? "none" : "a folder"));
  if (!report_folder.empty()) require_free(report_folder, got, want);
  const std::vector<Comparison> comparisons =
      are_folders ? compare_folders(got, want, limits, report_folder)
                  : std::vector{compare_pair(got, want, limits, report_folder)};
  Verdict result = verdict(comparisons, are_folders ? folders_json(got, want, comparisons, limits)
                                                    : to_json(comparisons.front(), limits));
  if (report_folder.empty()) return result;
  make_folder(report_folder);
  write_file(report_folder / "metrics.json", result.json);
  write_report_page(report_folder / "index.html", comparisons);
  return result;
}

}  // namespace wold::compare
