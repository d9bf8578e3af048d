#include "work/manifest.h"

#include <nlohmann/json.hpp>

#include "core/file_list.h"
#include "core/files.h"
#include "film/exporters.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

constexpr const char* file_name = "manifest.json";

/// What a record says of a picture.
struct Origin {
  std::string source;
  std::string hash;  ///< of the picture
  double seconds = 0.0;
};

std::string stage_of(const fs::path& relative) {
  return relative.has_parent_path() ? relative.begin()->string() : "scene";
}

bool is_listed(const fs::path& relative) {
  return relative != file_name && *relative.begin() != "tasks";
}

}  // namespace

void write_manifest(const fs::path& out, const TaskRecords& records, FileStates& states) {
  std::map<std::string, Origin> pictures;
  records.for_each([&](const std::string& stage, const TaskRecord& record) {
    for (const auto& [name, state] : record.outputs) {
      states.learn(name, state);
      if (exporter::find_exporter(film::exporters(), stage))
        pictures[name] = {record.source, state.hash, record.seconds};
    }
  });
  nlohmann::ordered_json json = {{"version", 1}, {"files", nlohmann::ordered_json::array()}};
  for (const fs::path& path : files_below(out)) {
    const fs::path relative = path.lexically_relative(out);
    if (!is_listed(relative)) continue;
    const std::string name = relative.generic_string();
    const FileState state = states.of(name);
    nlohmann::ordered_json file = {{"path", name},
                                   {"bytes", state.bytes},
                                   {"hash", state.hash},
                                   {"stage", stage_of(relative)}};
    if (const auto picture = pictures.find(name);
        picture != pictures.end() && picture->second.hash == state.hash) {
      file["source"] = picture->second.source;
      file["seconds"] = picture->second.seconds;
    }
    json["files"].push_back(std::move(file));
  }
  // A user's own files need not have names that are text.
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  update_file(out / file_name, json.dump(1, ' ', false, replace) + "\n");
}

}  // namespace wold::work
