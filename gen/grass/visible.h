#pragma once

#include <cstdint>
#include <vector>

#include "grass/texel.h"

namespace wold::grass {

/// Places of the voxels that are worth keeping, ascending: those with an optical depth across of
/// at least 0.02; all when there is none. In a meadow a third of the voxels are fainter, and hold
/// a hundredth of the grass. `density` in 1/m.
std::vector<std::uint32_t> visible_voxels(const std::vector<float>& density,
                                          const TexelShape& shape);

}  // namespace wold::grass
