#pragma once

#include <glm/glm.hpp>

#include "cloud/clouds.h"
#include "cloud/volume.h"

namespace wold::cloud {

/// A layer over a part of the world, from its base to its thickness above that. A volume over just
/// the layer's period repeats. `voxels` >= 1 each, side_m > 0.
///
/// A layer that stands in heaps has the droplets of those that lines of sight see (heaps.h), with
/// heads down to a voxel. Any other that has heads is filled column by column: its base flat at
/// base_m, its top thickness_m times (depth over the densest, smoothed over a sixth of the
/// thickness)^0.7 higher. Extinction rises over the lowest seventh and falls as sqrt(1 - t) to the
/// top, bitten into between round heads above the base (billow_box.h), and is scaled so that every
/// column has the optical depth of the droplets there: droplets_per_seen() times the layer's, as it
/// is seen. Throws std::bad_optional_access where the layer has no heads.
CloudVolume lifted(const LayerState& state, double pixel_m, const glm::dvec2& south_west_m,
                   const glm::dvec2& side_m, const glm::ivec3& voxels);

}  // namespace wold::cloud
