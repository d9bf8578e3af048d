#include "report/version_report.h"

#include <fmt/format.h>

#include <string_view>

#include "core/libraries.h"
#include "core/version.h"
#include "work/folder_format.h"

namespace wold::report {
namespace {

std::string line(std::string_view name, std::string_view value) {
  return fmt::format("{:11}{}\n", name, value);
}

std::string libraries_text() {
  std::string text;
  for (const LibraryVersion& library : library_versions())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", library.name, library.version);
  return text;
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

}  // namespace wold::report
