#include "blender/blender_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.h"
#include "render/short_run.h"

namespace wold::blender {
namespace {

constexpr std::string_view mark = "wold: module ";

/// Python looks into the current folder first, which is the empty name among its folders.
constexpr const char* question = R"(import sys
sys.path = [folder for folder in sys.path if folder]
import importlib.metadata, importlib.util, json
spec = importlib.util.find_spec("bpy")
try:
    version = importlib.metadata.version("bpy")
except importlib.metadata.PackageNotFoundError:
    version = "unknown"
print("wold: module " + json.dumps([spec.origin or "", version] if spec else None))
)";

/// Nothing when the line is no answer; null when it says that there is no module.
std::optional<nlohmann::json> parsed(const std::string& line) {
  if (!line.starts_with(mark)) return std::nullopt;
  nlohmann::json json = nlohmann::json::parse(line.substr(mark.size()), nullptr, false);
  const bool is_module =
      json.is_array() && json.size() == 2 && json[0].is_string() && json[1].is_string();
  return is_module || json.is_null() ? std::optional(std::move(json)) : std::nullopt;
}

}  // namespace

std::vector<std::string> python_command(const std::filesystem::path& python) {
  return {python.string(), "-E", "-B"};
}

std::optional<BlenderModule> find_blender_module(const std::filesystem::path& python,
                                                 const std::function<bool()>& interrupted) {
  std::vector<std::string> arguments = python_command(python);
  arguments.insert(arguments.end(), {"-c", question});
  const render::Answer answer = render::ask(arguments, render::neutral_folder, interrupted);
  for (const std::string& line : answer.lines) {
    const auto json = parsed(line);
    if (!json) continue;
    if (json->is_null()) return std::nullopt;
    return BlenderModule{(*json)[1].get<std::string>(), (*json)[0].get<std::string>()};
  }
  throw RendererError(fmt::format("{} does not say whether it has the package bpy: {}{}",
                                  python.string(), how_it_ended(answer), last_lines(answer)));
}

}  // namespace wold::blender
