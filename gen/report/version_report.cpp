#include "report/version_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/libraries.h"
#include "core/version.h"
#include "work/folder_format.h"

namespace wold::report {
namespace {

using Json = nlohmann::ordered_json;

std::string line(std::string_view name, std::string_view value) {
  return fmt::format("{:11}{}\n", name, value);
}

std::string libraries_text() {
  std::string text;
  for (const LibraryVersion& library : library_versions())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", library.name, library.version);
  return text;
}

Json json_of(const RendererHere& one) {
  Json json = {{"renderer", one.kind->program.name}, {"program", nullptr}, {"version", nullptr}};
  if (one.program) {
    json["program"] = one.program->found.path.string();
    json["version"] = one.program->version;
  }
  return json;
}

Json libraries_json() {
  Json libraries = Json::object();
  for (const LibraryVersion& library : library_versions())
    libraries[library.name] = library.version;
  return libraries;
}

}  // namespace

std::string version_text(const std::vector<RendererHere>& renderers,
                         const std::optional<render::OtherProgram>& ffmpeg) {
  std::string text = fmt::format("wold {}\n", version) + line("revision", revision()) +
                     line("built by", build) + line("libraries", libraries_text()) +
                     line("folders", fmt::format("of format {}", work::folder_format));
  for (const RendererHere& one : renderers)
    text += line("renderer", one.program ? described(*one.program)
                                         : std::string(display_name(*one.kind)) + ": missing");
  return text + line("films", ffmpeg ? fmt::format("FFmpeg {} ({})", ffmpeg->version, ffmpeg->path)
                                     : "FFmpeg: missing");
}

std::string version_json(const std::vector<RendererHere>& renderers,
                         const std::optional<render::OtherProgram>& ffmpeg) {
  Json programs = Json::array();
  for (const RendererHere& one : renderers) programs.push_back(json_of(one));
  Json json = {{"version", 1},
               {"wold", version},
               {"revision", revision()},
               {"built_by", build},
               {"libraries", libraries_json()},
               {"folder_format", work::folder_format},
               {"renderers", std::move(programs)},
               {"ffmpeg", nullptr}};
  if (ffmpeg) json["ffmpeg"] = {{"program", ffmpeg->path}, {"version", ffmpeg->version}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wold::report
