#include "grass/slice_sums.h"

namespace wold::grass {

std::vector<VoxelShare> SliceAreas::take_above(float least_m2) {
  VoxelShare* above = above_.data();
  float* area_m2 = area_m2_.data();
  for (std::size_t at = 0; at < touched_.size(); ++at) {
    if (touched_[at] == 0) continue;
    touched_[at] = 0;
    // Writing every voxel down and stepping on behind the right ones leaves nothing to guess.
    for (std::size_t ground = at * stretch; ground < (at + 1) * stretch; ++ground) {
      *above = {static_cast<std::uint32_t>(ground), area_m2[ground]};
      above += above->area_m2 > least_m2 ? 1 : 0;
      area_m2[ground] = 0.0F;
    }
  }
  return {above_.data(), above};
}

void SliceMoments::start(std::span<const VoxelShare> voxels) {
  for (const VoxelShare& voxel : voxels_) place_[voxel.ground] = 0;
  voxels_ = voxels;
  for (std::uint32_t i = 0; i < voxels.size(); ++i) place_[voxels[i].ground] = i + 1;
  sums_.assign(voxels.size() + 1, Moments());
}

}  // namespace wold::grass
