#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/elementary.h"
#include "grass/texel/texel_builder.h"
#include "grass/texel/voxelise.h"

namespace wold::grass::test {

/// The voxels of straight blades, ordered by slice.
class BladeContributions {
 public:
  BladeContributions(const std::vector<Blade>& blades, const TexelShape& shape, glm::vec3 albedo,
                     float specular)
      : slices_(static_cast<std::size_t>(shape.height)) {
    for (const Blade& blade : blades)
      for (const BladeVoxel& voxel : voxelise_blade(blade, shape)) {
        if (voxel.voxel.z >= shape.height) continue;
        slices_[static_cast<std::size_t>(voxel.voxel.z)].push_back(fractions_.size());
        fractions_.push_back(
            {shape.linear(shape.wrapped(voxel.voxel.x), shape.wrapped(voxel.voxel.y), 0),
             voxel.area_m2});
        moments_.emplace_back(
            glm::vec3(blade.heading * math::sin(blade.lean), math::cos(blade.lean)), voxel.normal,
            albedo, 0.5F * albedo, specular);
      }
  }
  double area_m2() const {
    double sum = 0.0;
    for (const VoxelWeight& fraction : fractions_) sum += double{fraction.area_m2};
    return sum;
  }

  template <class Visit>
  void each_in_slice(int z, const Visit& visit) const {
    for (std::size_t which : slices_[static_cast<std::size_t>(z)])
      visit(which, std::span<const VoxelWeight, 1>(&fractions_[which], 1));
  }
  const Moments& moments(std::size_t which) const { return moments_[which]; }

 private:
  std::vector<std::vector<std::size_t>> slices_;
  std::vector<VoxelWeight> fractions_;
  std::vector<Moments> moments_;
};

/// The texel of fresh, straight cones, which that of points is judged by: the sum of all blades'
/// voxels. What stands out above the texel is cut off; attributes are averaged by area, tangents as
/// dyads.
inline Texel voxelised(const std::vector<Blade>& blades, const TexelShape& shape, glm::vec3 albedo,
                       float specular) {
  const BladeContributions contributions(blades, shape, albedo, specular);
  return build_texel(shape, contributions, contributions.area_m2());
}

}  // namespace wold::grass::test
