#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace wold::mitsuba {

/// The bytes of a grid volume as Mitsuba reads it, little-endian:
///
///     0   "VOL"
///     3   version, 3
///     4   type of the numbers as 32 bits, 1: floats of 32 bits
///     8   voxels along x, y and z, 32 bits each
///     20  channels, 32 bits
///     24  box from (0, 0, 0) to (1, 1, 1), six floats: the scene places it
///     48  values, x fastest, then y, then z, the channels of a voxel side by side
///
/// Throws std::invalid_argument where the values are not as many as the voxels.
std::string grid_bytes(const glm::ivec3& voxels, const std::vector<float>& values);
std::string grid_bytes(const glm::ivec3& voxels, const std::vector<glm::vec3>& values);

}  // namespace wold::mitsuba
