#pragma once

#include "render/renderer.h"

/// POV-Ray as a program: what is asked of it, by --version, a probe and a command line.
namespace wold::povray {

/// `povray`, 3.7 or later.
const render::Renderer& renderer();

}  // namespace wold::povray
