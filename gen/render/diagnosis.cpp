#include "render/diagnosis.h"

#include <filesystem>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/interrupt.h"
#include "render/encode.h"
#include "render/probe_cache.h"
#include "render/short_run.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

/// "/usr/bin/blender" of a link to it.
fs::path target_of(const fs::path& program) {
  std::error_code ignored;
  const fs::path target = fs::canonical(program, ignored);
  return ignored ? program : target;
}

/// Of "blender": "blender", "blender-4.5" and "blender5.2", but not "blender-thumbnailer".
bool is_numbered_name(const std::string& name, std::string_view prefix) {
  return name.find_first_not_of("-.0123456789", prefix.size()) == std::string::npos;
}

/// Nothing when it does not say that it is one.
std::optional<OtherProgram> build_at(const fs::path& path, const Renderer& kind) {
  try {
    const render::RendererProgram program = render::recognise(kind, {path, "PATH"}, interrupted);
    return OtherProgram{path.string(), program.version};
  } catch (const RendererError&) {
    return std::nullopt;
  }
}

/// "5.1.6" of "ffmpeg version 5.1.6 Copyright ...".
std::string ffmpeg_version(const render::Answer& answer) {
  if (answer.lines.empty()) return "unknown";
  std::istringstream words(answer.lines.front());
  std::string name, version, number;
  words >> name >> version >> number;
  return name == "ffmpeg" && version == "version" ? number : "unknown";
}

}  // namespace

Diagnosis diagnose(const render::Renderer& kind, const std::string& chosen) {
  Diagnosis diagnosis;
  diagnosis.kind = &kind;
  try {
    diagnosis.found = render::find_renderer(kind, chosen);
    diagnosis.program = render::recognise(kind, *diagnosis.found, interrupted);
    diagnosis.can = render::probe_anew(*diagnosis.program, interrupted);
  } catch (const RendererError& error) {
    diagnosis.problem = error.what();
  }
  return diagnosis;
}

std::optional<RendererProgram> program_on_machine(const Renderer& kind) {
  try {
    return recognise(kind, find_renderer(kind, ""), interrupted);
  } catch (const RendererError&) {
    return std::nullopt;
  }
}

std::string_view state_of(const Diagnosis& diagnosis) {
  if (!diagnosis.found) return "missing";
  if (!diagnosis.program) return "unknown";
  if (!diagnosis.can) return "failing";
  return is_complete(diagnosis) ? "complete" : "lacking";
}

std::vector<OtherProgram> other_builds(const Diagnosis& diagnosis) {
  const Renderer& kind = *diagnosis.kind;
  if (!kind.has_numbered_names) return {};
  std::set<fs::path> seen;
  if (diagnosis.found) seen.insert(target_of(diagnosis.found->path));
  std::vector<OtherProgram> others;
  for (const fs::path& path : render::programs_on_path(kind.program.name)) {
    if (!is_numbered_name(path.filename().string(), kind.program.name)) continue;
    if (!seen.insert(target_of(path)).second) continue;
    if (auto other = build_at(path, kind)) others.push_back(std::move(*other));
  }
  return others;
}

std::optional<OtherProgram> diagnose_ffmpeg() {
  try {
    const std::string path = render::find_ffmpeg().path.string();
    const render::Answer answer =
        render::ask({path, "-version"}, render::neutral_folder, interrupted);
    return OtherProgram{path, ffmpeg_version(answer)};
  } catch (const RendererError&) {
    return std::nullopt;
  }
}

}  // namespace wold::render
