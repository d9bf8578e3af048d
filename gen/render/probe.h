#pragma once

#include <string>

#include "render/capabilities.h"
#include "render/renderer_program.h"

namespace wold::render {

/// Lets a renderer make pictures of next to nothing, and says what was seen in them: a second or
/// two. Takes as long as longest_answer at most. `interrupted` is asked several times a second.
/// Throws RendererError when the program fails or does not answer, FileError and InterruptedError.
Capabilities probe(const RendererProgram& program, const Interrupted& interrupted);

/// Equal as long as probe() asks the same: hash of what it lets the renderer run.
std::string probe_content(const RendererProgram& program);

}  // namespace wold::render
