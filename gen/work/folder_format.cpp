#include "work/folder_format.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "core/printable.h"
#include "core/version.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

struct Origin {
  std::int64_t format = 1;
  std::string program = "another version of wold";  ///< that made the folder
};

fs::path file_of(const fs::path& out) { return out / "tasks/format.json"; }

Origin origin_of(const fs::path& out) {
  std::error_code ignored;
  if (!fs::is_regular_file(file_of(out), ignored)) return {};
  const Json json = Json::parse(read_file(file_of(out)), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("format") || !json["format"].is_number_integer())
    return {};
  Origin origin;
  origin.format = json["format"].get<std::int64_t>();
  if (json.contains("wold") && json["wold"].is_string())
    origin.program = "wold " + printable(json["wold"].get<std::string>());
  return origin;
}

}  // namespace

void write_folder_format(const fs::path& out) {
  const Json json = {{"format", folder_format}, {"wold", version}};
  update_file(file_of(out), json.dump() + "\n");
}

void require_known_format(const fs::path& out) {
  const Origin origin = origin_of(out);
  if (origin.format == folder_format) return;
  throw InputError(fmt::format(
      "found {0}, an output folder of format {1} that {2} has made; wold {3} expected format {4}: "
      "take {2}, or make its pictures anew in another folder by `wold render {0}/scene.toml --out "
      "ANOTHER`",
      out.string(), origin.format, origin.program, version, folder_format));
}

}  // namespace wold::work
