#include "render/probe_cache.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "core/temporary_name.h"
#include "render/capabilities_json.h"
#include "render/probe.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

/// Of the file that a link leads to.
json state_of(const fs::path& file) {
  std::error_code ignored;
  const fs::path target = fs::canonical(file, ignored);
  return {{"path", file.string()},
          {"target", target.string()},
          {"bytes", fs::file_size(target, ignored)},
          {"time", fs::last_write_time(target, ignored).time_since_epoch().count()}};
}

json key_of(const RendererProgram& program) {
  json key = {{"machine", host_name()},
              {"renderer", display_name(*program.kind)},
              {"program", state_of(program.found.path)},
              {"version", program.version},
              {"probe", probe_content(program)}};
  if (!program.module.empty()) key["module"] = state_of(program.module);
  return key;
}

/// Names of files need not be text.
std::string text_of(const json& value) {
  return value.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

/// Empty where nothing can be kept.
fs::path file_of(const json& key) {
  const auto folder = probe_cache_folder();
  if (!folder) return {};
  return *folder / fmt::format("probe_{}.json", content_hash(text_of(key)));
}

std::optional<Capabilities> read(const fs::path& file, const json& key) {
  try {
    const json kept = json::parse(read_file(file));
    if (text_of(kept.at("key")) != text_of(key)) return std::nullopt;
    return capabilities_of(kept.at("capabilities"));
  } catch (const FileError&) {
    return std::nullopt;  // nothing is kept
  } catch (const json::exception&) {
    return std::nullopt;  // it is damaged
  }
}

void write(const fs::path& file, const json& key, const Capabilities& capabilities) {
  if (file.empty()) return;
  try {
    make_folder(file.parent_path());
    write_file(file, text_of({{"key", key}, {"capabilities", to_json(capabilities)}}));
  } catch (const FileError&) {
    // The next run asks again.
  }
}

/// Empty unless it names an absolute path, as the XDG Base Directory Specification has it.
fs::path folder_of_variable(const char* name) {
  const char* value = std::getenv(name);
  const fs::path folder = value == nullptr ? "" : value;
  return folder.is_absolute() ? folder : fs::path();
}

}  // namespace

std::optional<fs::path> probe_cache_folder() {
  if (const fs::path cache = folder_of_variable("XDG_CACHE_HOME"); !cache.empty())
    return cache / "wold";
  if (const fs::path home = folder_of_variable("HOME"); !home.empty())
    return home / ".cache" / "wold";
  return std::nullopt;
}

Capabilities probe_anew(const RendererProgram& program, const Interrupted& interrupted) {
  Capabilities capabilities = probe(program, interrupted);
  const json key = key_of(program);
  write(file_of(key), key, capabilities);
  return capabilities;
}

ProbeAnswer probe_once(const RendererProgram& program, const Interrupted& interrupted) {
  const json key = key_of(program);
  if (auto kept = read(file_of(key), key)) return {std::move(*kept), false};
  return {probe_anew(program, interrupted), true};
}

}  // namespace wold::render
