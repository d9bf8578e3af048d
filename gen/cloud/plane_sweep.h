#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "cloud/periodic_map.h"
#include "cloud/voxel_box.h"

namespace wold::cloud {

/// From the voxels of one plane of a box to where a direction meets the next plane. Planes stand
/// across the axis along which the direction passes the most of them; in a box that repeats, which
/// has no first plane to the sides, they are level.
struct PlaneStep {
  int axis = 2;
  std::array<int, 2> across{0, 1};  ///< the axes in the plane
  glm::ivec2 shift{0};              ///< to the lower one of the four voxels around that place
  glm::vec4 weights{0.0F};          ///< of the four, the first of `across` fastest
  double length_m = 0.0;            ///< of the way
  int border = 1;                   ///< voxels beyond a plane that it may ask for

  /// A unit vector; not a level one where the box repeats.
  PlaneStep(const VoxelBox& box, const glm::dvec3& direction);

  int planes(const VoxelBox& box) const { return box.voxels[axis]; }
  glm::ivec2 plane_size(const VoxelBox& box) const {
    return {box.voxels[across[0]], box.voxels[across[1]]};
  }
  /// Where the numbers of a voxel of a plane are stored.
  std::size_t index(const VoxelBox& box, int plane, int x, int y) const {
    glm::ivec3 voxel;
    voxel[axis] = plane;
    voxel[across[0]] = x;
    voxel[across[1]] = y;
    return box.index(voxel);
  }
};

/// Numbers of a plane, with a border around it.
template <class T>
class BorderedPlane {
 public:
  BorderedPlane(const glm::ivec2& size, int border, const T& value)
      : size_(size),
        border_(border),
        width_(size.x + 2 * border),
        values_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(size.y + 2 * border),
                value) {}

  T& at(int x, int y) { return values_[offset(x, y)]; }

  /// Between the four voxels around the place that a step from a voxel leads to.
  T after(const PlaneStep& step, int x, int y) const {
    const T* low = &values_[offset(x + step.shift.x, y + step.shift.y)];
    const T* high = low + width_;
    return step.weights.x * low[0] + step.weights.y * low[1] + step.weights.z * high[0] +
           step.weights.w * high[1];
  }

  /// Puts into the border what lies at the other side.
  void repeat() {
    for (int y = -border_; y < size_.y + border_; ++y)
      for (int x = -border_; x < size_.x + border_; ++x)
        if (x < 0 || y < 0 || x >= size_.x || y >= size_.y)
          at(x, y) = at(wrapped_index(x, size_.x), wrapped_index(y, size_.y));
  }

 private:
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y + border_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x + border_);
  }

  glm::ivec2 size_;
  int border_, width_;
  std::vector<T> values_;
};

}  // namespace wold::cloud
