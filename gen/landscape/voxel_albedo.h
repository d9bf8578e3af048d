#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "landscape/landscape.h"

namespace wold::landscape {

/// The albedo of single scattering in each voxel of a volume, linear sRGB, x fastest, then y, then
/// z: means of Volume::texel, weighted by its density; where a voxel has no grass that of all the
/// patch. Throws FileError when the file is missing, damaged or not that of a texel.
std::vector<glm::vec3> voxel_albedo(const Volume& volume);

}  // namespace wold::landscape
