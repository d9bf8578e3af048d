#include "cli/manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/files.h"

namespace wold::cli {
namespace fs = std::filesystem;
namespace {

constexpr const char* file_name = "manifest.json";

/// Every file of ours below the folder, relative to it, in a fixed order. Temporary names start
/// with a dot.
std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path relative = entry.path().lexically_relative(folder);
    if (entry.is_regular_file() && relative != file_name &&
        !relative.filename().string().starts_with('.'))
      files.push_back(relative);
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string stage_of(const fs::path& relative) {
  return relative.has_parent_path() ? relative.begin()->string() : "scene";
}

}  // namespace

Manifest::Manifest(fs::path folder) : folder_(std::move(folder)) {
  std::error_code ignored;
  if (!fs::exists(folder_ / file_name, ignored)) return;
  const auto json = nlohmann::json::parse(read_file(folder_ / file_name), nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) return;
  for (const auto& file : json["files"])
    if (file.is_object() && file.contains("source") && file["source"].is_string() &&
        file.contains("path") && file["path"].is_string())
      pictures_[file["path"].get<std::string>()] = {
          file["source"].get<std::string>(), file.contains("seconds") && file["seconds"].is_number()
                                                 ? file["seconds"].get<double>()
                                                 : 0.0};
}

bool Manifest::is_current(const fs::path& picture, const std::string& source) const {
  std::error_code ignored;
  const auto known = pictures_.find(picture.generic_string());
  return known != pictures_.end() && known->second.source == source &&
         fs::is_regular_file(folder_ / picture, ignored);
}

void Manifest::add_picture(const fs::path& picture, const std::string& source, double seconds) {
  pictures_[picture.generic_string()] = {source, seconds};
  write();
}

const Manifest::Content& Manifest::content_of(const fs::path& relative) {
  const fs::path path = folder_ / relative;
  const fs::file_time_type changed = fs::last_write_time(path);
  Content& content = contents_[relative];
  if (content.hash.empty() || content.changed != changed) {
    const std::string bytes = read_file(path);
    content = {bytes.size(), changed, content_hash(bytes)};
  }
  return content;
}

void Manifest::write() {
  nlohmann::ordered_json json;
  json["version"] = 1;
  json["files"] = nlohmann::ordered_json::array();
  for (const fs::path& relative : files_below(folder_)) {
    const Content& content = content_of(relative);
    nlohmann::ordered_json file = {{"path", relative.generic_string()},
                                   {"bytes", content.bytes},
                                   {"hash", content.hash},
                                   {"stage", stage_of(relative)}};
    const auto picture = pictures_.find(relative.generic_string());
    if (picture != pictures_.end()) {
      file["source"] = picture->second.source;
      file["seconds"] = picture->second.seconds;
    }
    json["files"].push_back(std::move(file));
  }
  write_file(folder_ / file_name, json.dump(1) + "\n");
}

}  // namespace wold::cli
