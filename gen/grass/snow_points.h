#pragma once

#include <vector>

#include "grass/blade.h"
#include "grass/points.h"

namespace wold::grass {

/// The snow on posed blades as points of its own, two to every `step_m` > 0 of a blade that bears
/// some, the side of a voxel: white, dull, along the blade, on its upper side. From above they hide
/// the blade, from below it hides them.
///
/// Their area is one to three times that of the ridges (snow_ridge.h), the more the better a ridge
/// fills its voxels. A texel lets as much light through as fog of the same area: a third on the way
/// through a solid body. Opaque blades are put right by the fit of the whole texel's extinction
/// (fitted_density()); that snow hides the blade under it has to be put right here. With three, a
/// texel of voxels of 2.4 mm shows from above the colour that opaque blades show within 0.01 at a
/// quarter of the most snow, 0.04 at half, 0.15 at the most.
Points snow_points(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                   double step_m);

}  // namespace wold::grass
