#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/command.h"
#include "render/renderer_program.h"

/// Blender as a program: what is asked of it, by --version, a probe and a command line.
namespace wold::blender {

/// Blender itself, or a Python that has the package bpy.
const render::Renderer& renderer();

/// What runs wold_render.py in Blender or Python with these arguments. It is started in a folder
/// from which nothing is imported: never in that of the data.
render::Command launch(const render::RendererProgram& program,
                       const std::vector<std::string>& arguments);

}  // namespace wold::blender
