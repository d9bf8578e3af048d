#pragma once

#include <cstdint>
#include <vector>

#include "grass/texel/texel.h"

namespace wold::grass {

/// Density of the faintest voxel worth keeping, 1/m: an optical depth across of 0.02. In a meadow
/// most of the voxels that hold any grass are fainter, and hold a few hundredths of it.
float faintest_density(const TexelShape& shape);

/// Places of the voxels that are worth keeping, ascending; all when there is none. `density` in
/// 1/m.
std::vector<std::uint32_t> visible_voxels(const std::vector<float>& density,
                                          const TexelShape& shape);

}  // namespace wold::grass
