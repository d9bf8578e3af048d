#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "landscape/coarse_colours.h"

namespace wold::landscape {

/// What a volume emits, extinction times source radiance, as brightness and colour apart: eyes, and
/// pictures of grass, have far less detail in colour. Grids run x fastest, then y, then z.
struct EmittedLight {
  std::vector<float> luminance_per_m;  ///< relative luminance of the radiance gained per metre
  ColourGrid colours;                  ///< of luminance 1, linear sRGB, at half the resolution
};

/// Of a volume of `voxels` voxels: `extinction_per_m` and `radiance` of each, both at least as
/// many.
EmittedLight emitted_light(std::span<const float> extinction_per_m, std::vector<glm::vec3> radiance,
                           glm::ivec3 voxels);

}  // namespace wold::landscape
