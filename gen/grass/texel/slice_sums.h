#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "grass/texel/moments.h"

namespace wold::grass {

/// Area summed up over the voxels of a slice. Grass touches a few stretches of a slice only;
/// nothing else is looked at.
class SliceAreas {
 public:
  explicit SliceAreas(const TexelShape& shape)
      : area_m2_(shape.slice_voxels() + stretch),
        touched_(area_m2_.size() / stretch),
        above_(std::make_unique_for_overwrite<VoxelWeight[]>(area_m2_.size())) {}

  template <std::size_t Count>
  void add(std::span<const VoxelWeight, Count> weights) {
    empty_ = false;
    for (const VoxelWeight& to : weights) {
      area_m2_[to.ground] += to.area_m2;
      touched_[to.ground / stretch] = 1;
    }
  }

  /// The voxels that hold more than `min_m2`, ascending; empties the slice.
  std::vector<VoxelWeight> take_above(float min_m2);

 private:
  static constexpr std::size_t stretch = 16;  // voxels

  bool empty_ = true;
  std::vector<float> area_m2_;
  std::vector<std::uint16_t> touched_;    ///< 1 for stretches that are; bytes could alias all else
  std::unique_ptr<VoxelWeight[]> above_;  ///< room for what take_above() finds
};

/// Moments summed up over some voxels of a slice; fractions of others are left out.
class SliceMoments {
 public:
  explicit SliceMoments(const TexelShape& shape) : place_(shape.slice_voxels()) {}

  /// Starts anew with these voxels, which have to outlive the sums.
  void start(std::span<const VoxelWeight> voxels);

  template <std::size_t Count>
  void add(const Moments& per_area, std::span<const VoxelWeight, Count> weights) {
    for (const VoxelWeight& to : weights) sums_[place_[to.ground]].add(per_area, to.area_m2);
  }

  /// The sums in the order of the voxels.
  std::span<const Moments> sums() const { return std::span(sums_).subspan(1); }

 private:
  /// Of a voxel's sum; 0, where nobody looks, for voxels that are left out. Few are, so that adding
  /// up what nobody needs is faster than asking.
  std::vector<std::uint32_t> place_;
  std::span<const VoxelWeight> voxels_;
  std::vector<Moments> sums_;
};

}  // namespace wold::grass
