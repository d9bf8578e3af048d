#pragma once

#include "scene/rule.h"
#include "scene/scene.h"

/// What a scene needs of the machine that makes it. Reading a scene asks for none of it, so that a
/// scene is as right on one machine as on another.
namespace wold::film {

/// Throws InputError for every file that the scene names and that is not there, at the place of its
/// key.
void require_files(const scene::Scene& scene, const scene::Places& places = {});

/// Throws InputError, at the place of the first key to blame, when the machine's memory is too
/// small for the texels that are made at the same time.
void require_texel_memory(const scene::Scene& scene, const scene::Places& places = {});

}  // namespace wold::film
