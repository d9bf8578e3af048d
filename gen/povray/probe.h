#pragma once

#include <string_view>

#include "render/capabilities.h"
#include "render/renderer_program.h"

namespace wold::povray {

/// The scene that shows what a POV-Ray can: on the left a density file of one voxel, on the right a
/// medium that is the same everywhere, both glowing before nothing.
std::string_view probe_scene();

/// Renders that scene in a folder for temporary files; see render::probe().
render::Capabilities probe(const render::RendererProgram& program,
                           const render::Interrupted& interrupted);

}  // namespace wold::povray
