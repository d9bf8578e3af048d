#pragma once

#include <algorithm>

#include "core/parallel.h"
#include "grass/texel/slice_sums.h"
#include "grass/texel/texel.h"
#include "grass/texel/visible.h"

namespace wold::grass {

/// The voxels of a slice that are kept.
struct KeptSlice {
  std::vector<VoxelWeight> voxels;  ///< ascending
  double area_m2 = 0.0;
  std::size_t begin = 0;  ///< place of the first one in the texel
};

/// The voxels denser than `min`, slice by slice.
template <class Contributions>
std::vector<KeptSlice> voxels_above(const TexelShape& shape, const Contributions& contributions,
                                    float min) {
  const auto min_m2 = static_cast<float>(min * shape.voxel_volume_m3());
  std::vector<KeptSlice> slices(static_cast<std::size_t>(shape.height));
  const auto scratch = [&] { return SliceAreas(shape); };
  parallel_for_with_scratch(slices.size(), scratch, [&](std::size_t z, SliceAreas& areas) {
    const auto add = [&](std::size_t, auto weights) { areas.add(weights); };
    contributions.each_in_slice(static_cast<int>(z), add);
    slices[z].voxels = areas.take_above(min_m2);
    for (const VoxelWeight& voxel : slices[z].voxels) slices[z].area_m2 += double{voxel.area_m2};
  });
  std::size_t begin = 0;
  for (KeptSlice& slice : slices) {
    slice.begin = begin;
    begin += slice.voxels.size();
  }
  return slices;
}

double area_m2_of(const std::vector<KeptSlice>& slices);

/// A texel with room for these voxels.
Texel texel_for(const TexelShape& shape, const std::vector<KeptSlice>& slices);

/// Writes which voxels a slice has and how dense they are.
void write_densities(const KeptSlice& slice, int z, float per_area, Texel& texel);

/// Gathers bits of grass into a texel. Slices are made independently, each in two passes: areas
/// first, then, for the voxels that are bright enough to be seen, everything else (write_means()).
/// A meadow touches nearly twice as many voxels as it fills visibly, and a slice stays in the
/// processor's cache.
///
/// Voxels too faint to see (visible.h) are left out and their area is given to the others, in
/// proportion; when all are faint, all are kept. `area_m2` is that of all contributions together.
///
/// Contributions has each_in_slice(z, visit), which calls visit(which, shares), a span of
/// VoxelWeight, for every bit that reaches the slice at height z, and moments(which). The slices
/// are asked for twice, several at once; always in the same order, because sums depend on it.
template <class Contributions>
Texel build_texel(const TexelShape& shape, const Contributions& contributions, double area_m2) {
  auto slices = voxels_above(shape, contributions, faintest_density(shape));
  if (area_m2_of(slices) == 0.0) slices = voxels_above(shape, contributions, 0.0F);
  const auto per_area = static_cast<float>(area_m2 / area_m2_of(slices) / shape.voxel_volume_m3());
  Texel texel = texel_for(shape, slices);
  const auto scratch = [&] { return SliceMoments(shape); };
  parallel_for_with_scratch(slices.size(), scratch, [&](std::size_t z, SliceMoments& moments) {
    const KeptSlice& slice = slices[z];
    moments.start(slice.voxels);
    const auto add = [&](std::size_t which, auto weights) {
      moments.add(contributions.moments(which), weights);
    };
    contributions.each_in_slice(static_cast<int>(z), add);
    write_densities(slice, static_cast<int>(z), per_area, texel);
    write_means(moments.sums(), slice.voxels, slice.begin, texel);
  });
  return texel;
}

}  // namespace wold::grass
