#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "cloud/voxel_box.h"

namespace wold::cloud {

/// Optical depth, at every voxel's centre, of the way through the box in that direction, which is a
/// unit vector and, where the box repeats, not level; half of the voxel itself counts. Plane by
/// plane (plane_sweep.h) from the side that the way leaves by: bilinear in the plane before, clear
/// sky or the repetition outside.
std::vector<float> depth_towards(const VoxelBox& box, const std::vector<float>& extinction_per_m,
                                 const glm::dvec3& direction);

}  // namespace wold::cloud
