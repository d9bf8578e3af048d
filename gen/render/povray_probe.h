#pragma once

#include <functional>
#include <string_view>

#include "render/capabilities.h"
#include "render/renderer_program.h"

namespace wold::render {

/// The scene that shows what a POV-Ray can: on the left a density file of one voxel, on the right a
/// medium that is the same everywhere, both glowing before nothing.
std::string_view povray_probe_scene();

/// Renders that scene in a folder for temporary files; see probe().
Capabilities probe_povray(const RendererProgram& program, const std::function<bool()>& interrupted);

}  // namespace wold::render
