#pragma once

#include <cstddef>
#include <glm/glm.hpp>

namespace wold::cloud {

/// A box of voxels. Numbers of voxels are stored with x fastest, then y, then z, from the
/// south-west of the base up.
struct VoxelBox {
  glm::dvec3 corner_m = {};  ///< south-west corner of the base, world space
  glm::dvec3 voxel_m = {};   ///< sides of a voxel
  glm::ivec3 voxels = {};
  bool repeats = false;  ///< to the east and north: light comes in from the other side

  std::size_t count() const {
    return static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y) *
           static_cast<std::size_t>(voxels.z);
  }

  glm::dvec3 centre_m(const glm::ivec3& voxel) const {
    return corner_m + (glm::dvec3(voxel) + 0.5) * voxel_m;
  }

  /// Where the numbers of a voxel of the box are stored.
  std::size_t index(const glm::ivec3& voxel) const {
    return (static_cast<std::size_t>(voxel.z) * static_cast<std::size_t>(voxels.y) +
            static_cast<std::size_t>(voxel.y)) *
               static_cast<std::size_t>(voxels.x) +
           static_cast<std::size_t>(voxel.x);
  }
};

}  // namespace wold::cloud
