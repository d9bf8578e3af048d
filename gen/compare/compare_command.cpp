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

Verdict verdict(const std::vector<Comparison>& comparisons, const Json& json) {
  Verdict result;
  result.code = std::ranges::all_of(comparisons, is_same) ? ExitCode::done : ExitCode::different;
  result.json = text(json);
  std::vector<std::string> lines;
  std::ranges::transform(comparisons, std::back_inserter(lines), to_line);
  result.lines = fmt::format("{}", fmt::join(lines, "\n"));
  return result;
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
