#include "cloud/optical_sweep.h"

#include <cmath>

#include "cloud/periodic_map.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// Planes of numbers, x fastest.
struct Plane {
  const float* values;
  int width, height;
  bool repeats;

  float at(int x, int y) const {
    if (repeats) {
      x = wrapped_index(x, width);
      y = wrapped_index(y, height);
    } else if (x < 0 || y < 0 || x >= width || y >= height) {
      return 0.0F;
    }
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// A shift by parts of a pixel, the same for a whole plane.
struct PlaneShift {
  glm::ivec2 whole;
  std::array<float, 4> weights;

  explicit PlaneShift(const glm::dvec2& by) : whole(glm::floor(by)), weights() {
    const glm::vec2 part = by - glm::floor(by);
    weights = {(1.0F - part.x) * (1.0F - part.y), part.x * (1.0F - part.y),
               (1.0F - part.x) * part.y, part.x * part.y};
  }
};

/// to[x] += factor * the plane's value at (x, y) + shift, for a row.
void add_shifted(const Plane& plane, int y, const PlaneShift& shift, float factor, float* to) {
  for (int corner = 0; corner < 4; ++corner) {
    const float weight = factor * shift.weights[static_cast<std::size_t>(corner)];
    if (weight == 0.0F) continue;
    const int dx = shift.whole.x + (corner & 1), from_y = y + shift.whole.y + (corner >> 1);
    for (int x = 0; x < plane.width; ++x) to[x] += weight * plane.at(x + dx, from_y);
  }
}

}  // namespace

std::vector<float> depth_towards(const VoxelBox& box, const std::vector<float>& extinction_per_m,
                                 const glm::dvec3& direction) {
  const int up = direction.z > 0.0 ? 1 : -1;
  const double length_m = box.voxel_m.z / std::abs(direction.z);
  const PlaneShift shift(glm::dvec2(direction) * length_m / glm::dvec2(box.voxel_m));
  const auto half_m = static_cast<float>(0.5 * length_m);
  const auto plane_size =
      static_cast<std::size_t>(box.voxels.x) * static_cast<std::size_t>(box.voxels.y);
  std::vector<float> depth(box.count());
  for (int i = 0; i < box.voxels.z; ++i) {
    const int z = up > 0 ? box.voxels.z - 1 - i : i;
    const std::size_t here = static_cast<std::size_t>(z) * plane_size;
    const std::size_t before = static_cast<std::size_t>(i == 0 ? z : z + up) * plane_size;
    parallel_for(static_cast<std::size_t>(box.voxels.y), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      float* to = &depth[here + row * static_cast<std::size_t>(box.voxels.x)];
      const float* own = &extinction_per_m[here + row * static_cast<std::size_t>(box.voxels.x)];
      for (int x = 0; x < box.voxels.x; ++x) to[x] = half_m * own[x];
      if (i == 0) return;
      const Plane depths{&depth[before], box.voxels.x, box.voxels.y, box.repeats};
      const Plane extinctions{&extinction_per_m[before], box.voxels.x, box.voxels.y, box.repeats};
      add_shifted(depths, y, shift, 1.0F, to);
      add_shifted(extinctions, y, shift, half_m, to);
    });
  }
  return depth;
}

}  // namespace wold::cloud
