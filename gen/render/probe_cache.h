#pragma once

#include <filesystem>
#include <optional>

#include "render/capabilities.h"
#include "render/renderer_program.h"

namespace wold::render {

/// Where answers of probes are kept: $XDG_CACHE_HOME/wold, or ~/.cache/wold. Nothing where neither
/// is known.
std::optional<std::filesystem::path> probe_cache_folder();

/// A probe's answer and where it is from.
struct ProbeAnswer {
  Capabilities capabilities;
  bool is_new = true;  ///< the renderer was asked just now
};

/// What the program said when it was probed last on this machine: kept under its path, size, time
/// and version, a Python's also under its bpy's place, size and time, and under what the probe
/// asks. Probes it where nothing is kept. A file of the cache that is damaged or cannot be written
/// does no harm; processes may ask at the same time. Throws what probe() throws.
ProbeAnswer probe_once(const RendererProgram& program, const Interrupted& interrupted);

/// Probes it anew and keeps the answer. Throws what probe() throws.
Capabilities probe_anew(const RendererProgram& program, const Interrupted& interrupted);

}  // namespace wold::render
