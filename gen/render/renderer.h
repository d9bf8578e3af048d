#pragma once

#include <string>
#include <string_view>

#include "render/program.h"

namespace wold::render {

/// The external programs that make pictures.
enum class Renderer { blender, povray };

/// "Blender" or "POV-Ray", for people.
std::string_view display_name(Renderer renderer);

/// Where it is looked for.
const ExternalProgram& external_program(Renderer renderer);

/// The program: `chosen`, which --blender or --povray named, else $WOLD_BLENDER or $WOLD_POVRAY,
/// else the first `blender` or `povray` on the PATH; see find_program(). Throws RendererError that
/// names the Debian package to install when there is none.
FoundProgram find_renderer(Renderer renderer, const std::string& chosen = {});

}  // namespace wold::render
