#pragma once

#include "grass/texel/points.h"
#include "grass/texel/texel.h"

namespace wold::grass {

/// Points to texel ([TVT] section 2.3): every point is spread over the voxels around it with
/// Gaussian weights w = a exp(-d^2 / (2 sigma^2)), sigma 0.6 voxels, its own voxel and those
/// that share a face or an edge with it: a narrower one makes beads of thin blades that slant
/// through the grid.
///
/// a is chosen for every point so that its weights sum to one: [TVT]'s constant a keeps mass
/// only on average, this keeps it exactly, also at the ground and whatever sigma. [TVT]
/// divides the sum of weighted attributes by Num; dividing by the sum of the weights, as here,
/// makes it a mean, so that a constant field stays constant.
Texel rasterise_points(const Points& points, const TexelShape& shape);

}  // namespace wold::grass
