#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace wold::landscape {

/// Colours on a grid: x fastest, then y, then z.
struct ColourGrid {
  glm::ivec3 voxels{0};
  std::vector<glm::vec3> values;
};

/// Colours of a volume at half its resolution, an eighth of their bytes: of what it emits, where
/// brightness is kept at full resolution. Each coarse voxel has the mean of eight fine ones,
/// weighted by their `brightness`, at least 0: in sum it emits what they emit, and no air darkens
/// it. One without any has what the next coarser resolution has there, since renderers interpolate
/// colours and reach into it from the matter beside it. The grid ends at least one fine voxel above
/// the volume.
ColourGrid coarse_colours(std::span<const float> brightness, std::span<const glm::vec3> colours,
                          glm::ivec3 voxels);

}  // namespace wold::landscape
