#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/capabilities.h"
#include "render/renderer_program.h"

namespace wold::render {

/// What is known of a renderer on this machine.
struct Diagnosis {
  const render::Renderer* kind = nullptr;
  std::optional<render::FoundProgram> found;       ///< nothing: there is none
  std::optional<render::RendererProgram> program;  ///< nothing: it is something else
  std::optional<render::Capabilities> can;         ///< nothing: it did not answer
  std::string problem;                             ///< why one of these is not known; else empty
};

/// Looks for a renderer, `chosen` if that is not empty, and probes it anew. Throws
/// InterruptedError and FileError; that a renderer is missing or fails is an answer.
Diagnosis diagnose(const render::Renderer& kind, const std::string& chosen);

/// The program that a renderer's pictures would be made with, unprobed; nothing when there is none
/// or it is something else. Throws InterruptedError and FileError.
std::optional<RendererProgram> program_on_machine(const Renderer& kind);

/// "complete": it shows all that a scene can have. "lacking": not all. "failing": it does not
/// answer. "unknown": it is another program. "missing": there is none.
std::string_view state_of(const Diagnosis& diagnosis);

inline bool is_complete(const Diagnosis& diagnosis) {
  return diagnosis.can && diagnosis.can->volumes && diagnosis.can->fog;
}

/// A program that says its version; nothing else of it is known.
struct OtherProgram {
  std::string path;
  std::string version;
};

/// Other builds of a renderer that has_numbered_names, on the PATH under names such as
/// `blender-4.5`: those that say so, without links to the one that was diagnosed or to each other.
/// None of other renderers.
std::vector<OtherProgram> other_builds(const Diagnosis& diagnosis);

/// FFmpeg, for `wold film`; nothing when there is none.
std::optional<OtherProgram> diagnose_ffmpeg();

}  // namespace wold::render
