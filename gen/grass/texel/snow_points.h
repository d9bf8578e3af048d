#pragma once

#include <vector>

#include "grass/geometry/blade.h"
#include "grass/texel/points.h"

namespace wold::grass {

/// The snow on posed blades as points of its own, two to every `step_m` > 0 of a blade that bears
/// some, the side of a voxel: white, dull, along the blade, on its upper side. From above they hide
/// the blade, from below it hides them.
///
/// Their area is up to half as large again as that of the ridges (snow_ridge.h), the more the
/// better a ridge fills its voxels: a texel lets as much light through as fog of the same area, a
/// third on the way through a solid body, and what is opaque hides the blade under it. So a texel
/// of voxels of 2.4 mm shows the fraction of white that opaque blades show within 0.02 at an
/// elevation of 25 degrees and 0.05 at 45 degrees. From straight above it shows less, 0.08 at a
/// quarter of the most snow and 0.25 at the most: its extinction is the same from all sides.
Points snow_points(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                   double step_m);

}  // namespace wold::grass
