#include "cloud/plane_sweep.h"

#include <algorithm>
#include <cmath>

namespace wold::cloud {
namespace {

int axis_of(const VoxelBox& box, const glm::dvec3& direction) {
  if (box.repeats) return 2;
  const glm::dvec3 planes_per_m = glm::abs(direction) / box.voxel_m;
  int axis = 2;
  for (const int other : {0, 1})
    if (planes_per_m[other] > planes_per_m[axis] * (1.0 + 1e-9)) axis = other;
  return axis;
}

}  // namespace

PlaneStep::PlaneStep(const VoxelBox& box, const glm::dvec3& direction)
    : axis(axis_of(box, direction)),
      across{axis == 0 ? 1 : 0, axis == 2 ? 1 : 2},
      length_m(box.voxel_m[axis] / std::abs(direction[axis])) {
  const glm::dvec2 way(direction[across[0]] * length_m / box.voxel_m[across[0]],
                       direction[across[1]] * length_m / box.voxel_m[across[1]]);
  const glm::vec2 part(way - glm::floor(way));
  shift = glm::ivec2(glm::floor(way));
  weights = {(1.0F - part.x) * (1.0F - part.y), part.x * (1.0F - part.y), (1.0F - part.x) * part.y,
             part.x * part.y};
  border = static_cast<int>(std::ceil(std::max(std::abs(way.x), std::abs(way.y)))) + 1;
}

}  // namespace wold::cloud
