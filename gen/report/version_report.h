#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/diagnosis.h"

namespace wold::report {

/// A renderer's kind, and the program of it on this machine.
struct RendererHere {
  const render::Renderer* kind = nullptr;
  std::optional<render::RendererProgram> program;  ///< nothing: there is none
};

/// What `wold --version` says. The first line is "wold " and the version, and nothing more. After
/// it come a line each for the revision, compiler, libraries, the format of output folders, and
/// programs that make pictures and films.
std::string version_text(const std::vector<RendererHere>& renderers,
                         const std::optional<render::OtherProgram>& ffmpeg);

/// The same as JSON, for `wold --version --json`; docs/scripting.md has its fields.
std::string version_json(const std::vector<RendererHere>& renderers,
                         const std::optional<render::OtherProgram>& ffmpeg);

}  // namespace wold::report
