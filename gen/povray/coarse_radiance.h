#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace wold::povray {

/// Source radiance on a grid: x fastest, then y, then z.
struct RadianceGrid {
  glm::ivec3 voxels{0};
  std::vector<glm::vec3> radiance;
};

/// A volume's radiance at half its resolution, an eighth of its bytes. Each coarse voxel has the
/// mean of eight fine ones, weighted by extinction: it emits what they emit, and no air darkens it.
/// One without matter has what the next coarser resolution has there, since extinction that is
/// interpolated reaches into it from the matter beside it. The grid ends at least one fine voxel
/// above the volume.
///
/// Extinction at full resolution times this radiance is what a ray's radiance gains: extinction has
/// the fine shapes, and radiance changes slowly along blades and with height.
RadianceGrid coarse_radiance(std::span<const float> extinction, std::span<const glm::vec3> radiance,
                             glm::ivec3 voxels);

}  // namespace wold::povray
