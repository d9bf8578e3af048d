#include "work/own_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "core/error.h"
#include "core/files.h"
#include "film/exporters.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

bool is_within(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Names in a folder; none when there is no such folder or it cannot be read.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; at != end; at.increment(error))
    names.push_back(at->path().filename().string());
  return names;
}

/// "texels_0001.json", "scene_0123456789abcdef.json", "format.json", "lock"
bool is_name_of_record(std::string_view name) {
  constexpr std::array<std::string_view, 5> kinds = {"texels", "clouds", "passes", "scenes",
                                                     "scene"};
  if (name == "lock" || name == "format.json") return true;
  const std::string_view kind = name.substr(0, name.find('_'));
  return kind.size() < name.size() && name.ends_with(".json") &&
         (std::ranges::count(kinds, kind) > 0 || exporter::find_exporter(film::exporters(), kind));
}

/// At once, however many records there are; a folder that began without one has others.
bool has_format(const fs::path& folder) {
  std::error_code unknown;
  return fs::is_regular_file(folder / "tasks" / "format.json", unknown);
}

bool has_record(const fs::path& folder) {
  const std::vector<std::string> tasks = names_in(folder / "tasks");
  return std::ranges::any_of(tasks, is_name_of_record) || is_own_manifest(folder / "manifest.json");
}

/// What is there before the first run, or is not taken for somebody's work.
bool is_of_no_account(const fs::path& folder, const std::string& name) {
  if (name.starts_with('.') || name == "preview.png" || name == "report.html") return true;
  const std::vector<std::string> inside = names_in(folder / name);
  if (name == "logs") return inside == std::vector<std::string>{"slurm"};
  std::error_code unknown;
  const bool is_made_by_a_run = name == "tasks" || name == "snow" || name == "lost+found";
  return is_made_by_a_run && fs::is_directory(folder / name, unknown) && inside.empty();
}

void require_link_within(const fs::path& link, const fs::path& folder) {
  std::error_code unknown;
  const fs::path target = fs::weakly_canonical(link, unknown);
  if (unknown || !is_within(target, folder))
    throw FileError(
        fmt::format("{} is a link that leads out of the output folder, to {}: remove it, or "
                    "choose another folder (--out)",
                    link.string(), target.string()));
}

}  // namespace

bool is_own_manifest(const fs::path& file) {
  using Json = nlohmann::json;
  try {
    const Json json = Json::parse(read_file(file), nullptr, /*allow_exceptions=*/false);
    return json.is_object() && json.contains("version") && json.contains("files") &&
           std::ranges::all_of(json["files"], [](const Json& one) {
             return one.is_object() && one.contains("hash") && one.contains("stage");
           });
  } catch (const FileError&) {
    return false;
  }
}

void require_own_folder(const fs::path& folder) {
  if (has_format(folder)) return;
  const std::vector<std::string> names = names_in(folder);
  const auto own = std::ranges::find_if(
      names, [&](const std::string& name) { return !is_of_no_account(folder, name); });
  if (own != names.end() && !has_record(folder))
    throw InputError(fmt::format(
        "--out: found {} in {}, which wold has not made; expected a new or empty folder, or one of "
        "an earlier run: choose another by --out, or move away what lies there",
        *own, folder.string()));
}

void require_no_way_out(const fs::path& folder) {
  std::error_code error;
  const fs::path own = fs::canonical(folder, error);
  if (error) return;  // making it tells why
  fs::recursive_directory_iterator entry(own, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (std::error_code unknown; entry->is_symlink(unknown))
      require_link_within(entry->path(), own);
  }
}

void require_no_way_out(const fs::path& folder, std::span<const fs::path> below) {
  std::error_code error;
  const fs::path own = fs::canonical(folder, error);
  if (error) return;
  std::set<fs::path> places;
  for (const fs::path& one : below) {
    fs::path place = own;
    for (const fs::path& name : one) places.insert(place /= name);
  }
  for (const fs::path& place : places)
    if (std::error_code unknown; fs::is_symlink(place, unknown)) require_link_within(place, own);
}

}  // namespace wold::work
