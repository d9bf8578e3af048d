#pragma once

#include <string>

#include "render/capabilities.h"
#include "render/renderer_program.h"
#include "work/scene_needs.h"

namespace wold::work {

/// Why a renderer cannot make a scene's pictures, in one sentence: what was found, what it lacks
/// and what to do. Empty when it can.
std::string fault_of(const render::RendererProgram& program, const render::Capabilities& can,
                     const scene::Scene& scene);

/// "another build, an official Blender or a Python with the package bpy (pip install bpy), by
/// --blender or WOLD_BLENDER"
std::string other_build(const render::Renderer& renderer);

}  // namespace wold::work
