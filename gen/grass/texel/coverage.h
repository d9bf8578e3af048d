#pragma once

#include <vector>

#include "grass/geometry/blade.h"

namespace wold::grass {

/// Fraction of the ground that the tiled patch of opaque blades leaves uncovered, the mean over
/// `directions` (unit, towards the eye, z > 0; one at least): the mean transmittance the texel has
/// to show. The silhouettes of the bent cones are drawn into a mask of the ground that wraps.
double blade_transmittance(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                           double patch_m, const std::vector<glm::dvec3>& directions);

}  // namespace wold::grass
