#pragma once

#include <vector>

#include "grass/blade.h"
#include "grass/points.h"

namespace wold::grass {

/// The snow on posed blades as points of its own, two to every `step_m` > 0 of a blade that bears
/// some: white, dull, along the blade, on its upper side. From above they hide the blade, from
/// below it hides them. Their area is twice that of the ridges
/// (snow_ridge.h): a texel lets light through as an even fog of its area would, which is 0.37 of
/// it on the way through a solid body; a leaf is thin, but a ridge fills its voxels and hides what
/// is below.
Points snow_points(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                   double step_m);

}  // namespace wold::grass
