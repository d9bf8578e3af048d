#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "cloud/periodic_map.h"
#include "cloud/voxel_box.h"

namespace wold::cloud {

/// Where the numbers of the eight voxels around a place are stored and what each counts there,
/// trilinear. Outside a box it is as on its border, or in its repetition.
struct BetweenVoxels {
  std::array<std::size_t, 8> voxels;
  std::array<float, 8> weights;

  BetweenVoxels(const VoxelBox& box, const glm::dvec3& place_m) : voxels(), weights() {
    const glm::dvec3 at = (place_m - box.corner_m) / box.voxel_m - 0.5;
    const glm::dvec3 low = glm::floor(at);
    const glm::vec3 part(at - low);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const glm::ivec3 far(corner & 1, corner >> 1 & 1, corner >> 2);
      glm::ivec3 voxel = glm::ivec3(low) + far;
      if (box.repeats)
        for (const int axis : {0, 1}) voxel[axis] = wrapped_index(voxel[axis], box.voxels[axis]);
      voxels[corner] = box.index(glm::clamp(voxel, glm::ivec3(0), box.voxels - 1));
      const glm::vec3 parts = glm::mix(1.0F - part, part, glm::vec3(far));
      weights[corner] = parts.x * parts.y * parts.z;
    }
  }

  template <class T>
  T of(const std::vector<T>& values) const {
    T sum(0.0F);
    for (std::size_t i = 0; i < 8; ++i) sum += weights[i] * values[voxels[i]];
    return sum;
  }
};

}  // namespace wold::cloud
