#include "grass/texel/slice_sums.h"

#include <algorithm>

namespace wold::grass {

std::vector<VoxelWeight> SliceAreas::take_above(float min_m2) {
  if (empty_) return {};
  empty_ = true;
  VoxelWeight* above = above_.get();
  for (std::size_t at = 0; at < touched_.size(); ++at) {
    if (touched_[at] == 0) continue;
    touched_[at] = 0;
    float* const area_m2 = &area_m2_[at * stretch];
    const auto first = static_cast<std::uint32_t>(at * stretch);
    // Writing every voxel down and stepping on behind the right ones leaves nothing to guess.
    for (std::uint32_t i = 0; i < stretch; ++i) {
      *above = {first + i, area_m2[i]};
      above += area_m2[i] > min_m2 ? 1 : 0;
    }
    std::fill_n(area_m2, stretch, 0.0F);
  }
  return {above_.get(), above};
}

void SliceMoments::start(std::span<const VoxelWeight> voxels) {
  for (const VoxelWeight& voxel : voxels_) place_[voxel.ground] = 0;
  voxels_ = voxels;
  for (std::uint32_t i = 0; i < voxels.size(); ++i) place_[voxels[i].ground] = i + 1;
  sums_.assign(voxels.size() + 1, Moments());
}

}  // namespace wold::grass
