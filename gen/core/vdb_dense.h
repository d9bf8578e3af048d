#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace wold {

/// The values of a box of voxels of a FloatGrid on disk: `size` voxels from index `first` on, x
/// fastest, then y, then z; the background where nothing is stored. OpenVDB stays behind this
/// call. Throws FileError when the file or grid is missing, damaged or of another type.
std::vector<float> read_dense_floats(const std::filesystem::path& path, const std::string& grid,
                                     glm::ivec3 first, glm::ivec3 size);

/// The same for a Vec3SGrid.
std::vector<glm::vec3> read_dense_vectors(const std::filesystem::path& path,
                                          const std::string& grid, glm::ivec3 first,
                                          glm::ivec3 size);

}  // namespace wold
