#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/capabilities.h"
#include "render/renderer_program.h"

namespace wold::render {

/// What is known of a renderer on this machine.
struct Diagnosis {
  render::Renderer kind = render::Renderer::blender;
  std::optional<render::FoundProgram> found;       ///< nothing: there is none
  std::optional<render::RendererProgram> program;  ///< nothing: it is something else
  std::optional<render::Capabilities> can;         ///< nothing: it did not answer
  std::string problem;                             ///< why one of these is not known; else empty
};

/// Looks for a renderer, `chosen` if that is not empty, and probes it anew. Throws
/// InterruptedError and FileError; that a renderer is missing or fails is an answer.
Diagnosis diagnose(render::Renderer kind, const std::string& chosen);

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

/// Other Blenders on the PATH, such as `blender-4.5`: those that say so, without links to the one
/// that was diagnosed or to each other.
std::vector<OtherProgram> other_blenders(const Diagnosis& blender);

/// FFmpeg, for `wold film`; nothing when there is none.
std::optional<OtherProgram> diagnose_ffmpeg();

}  // namespace wold::render
