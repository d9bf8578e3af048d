#include "cloud/optical_sweep.h"

#include <utility>

#include "cloud/plane_sweep.h"
#include "core/parallel.h"

namespace wold::cloud {

std::vector<float> depth_towards(const VoxelBox& box, const std::vector<float>& extinction_per_m,
                                 const glm::dvec3& direction) {
  const PlaneStep step(box, direction);
  const auto half_m = static_cast<float>(0.5 * step.length_m);
  const int planes = step.planes(box);
  const glm::ivec2 size = step.plane_size(box);
  std::vector<float> depth(box.count());
  BorderedPlane<float> before(size, step.border, 0.0F), after = before;  // at half the way on
  for (int i = 0; i < planes; ++i) {
    const int plane = direction[step.axis] > 0.0 ? planes - 1 - i : i;
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < size.x; ++x) {
        const std::size_t voxel = step.index(box, plane, x, y);
        const float half_depth = half_m * extinction_per_m[voxel];
        depth[voxel] = before.after(step, x, y) + half_depth;
        after.at(x, y) = depth[voxel] + half_depth;
      }
    });
    std::swap(before, after);
    if (box.repeats) before.repeat();
  }
  return depth;
}

}  // namespace wold::cloud
