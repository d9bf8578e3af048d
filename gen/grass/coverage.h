#pragma once

#include <vector>

#include "grass/blade.h"

namespace wold::grass {

/// Share of the ground that the tiled patch of opaque blades leaves uncovered, seen along
/// `direction` (unit, towards the eye, z > 0): the mean transmittance the texel has to show. The
/// silhouettes of the bent cones are drawn into a mask of the ground that wraps.
double blade_transmittance(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                           double patch_m, const glm::dvec3& direction);

}  // namespace wold::grass
