#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "landscape/landscape.h"
#include "passes/seen_place.h"

namespace wold::passes {

/// The albedo of the leaves that are seen, of voxels by Volume::texel, of blades by Tubes, linear
/// sRGB; 0 where no grass is seen. Volumes are read one after another. Throws FileError.
std::vector<glm::vec3> leaf_albedo(const landscape::Landscape& landscape,
                                   std::span<const SeenPlace> seen);

}  // namespace wold::passes
