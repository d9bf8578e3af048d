#pragma once

#include <glm/glm.hpp>

#include "grass/mechanics/meadow_model.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// Mean irradiance of the ground that a tiled patch stands on: what passes between the blades of
/// sun and sky, and what they and the ground scatter down again. Where level ground in the open has
/// 1, it is the fraction that is left under grass.
glm::vec3 light_under_grass(const BladePatch& patch, const MeadowModel& model,
                            const Lighting& lighting);

}  // namespace wold::grass
