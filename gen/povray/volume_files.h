#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "landscape/landscape.h"

namespace wold::povray {

/// A volume's grids (x fastest, then y, then z) as POV-Ray has to be given them.
///
/// POV-Ray puts sample i of a df3 file of n samples at i/n of its box, is zero outside the box and
/// blends the last sample with the first. Wold's voxel i has its centre at (i + 0.5) voxels. So the
/// box is widened by one voxel on all sides and moved by half a voxel: in x and y the border
/// repeats the other side (the patch tiles), below it repeats the lowest slice (nothing is lost
/// between the ground and the first centre), above it is empty (the top fades out).
glm::ivec3 padded_size(glm::ivec3 voxels);
std::vector<float> padded(std::span<const float> values, glm::ivec3 voxels);

/// Height of the last slice with a value above zero, in voxels; at least 1.
int filled_height(std::span<const float> values, glm::ivec3 voxels);

/// Writes a cloud likewise, always anew.
void write_cloud(const landscape::CloudBox& cloud, int bits, const std::filesystem::path& folder);

/// Writes below `folder` <name>_d.df3 (extinction), <name>_r.df3, _g.df3, _b.df3 (extinction times
/// source radiance per channel; 8 or 16 bit integers of the volume's own maxima) and, last,
/// <name>.inc with size, maxima, content hash and the hashes of the four. Does nothing when the
/// .inc already has this content and they are as it says. Throws FileError.
void write_volume(const landscape::Volume& volume, int bits, const std::filesystem::path& folder);

/// The files of a volume of that name.
std::vector<std::filesystem::path> volume_files(const std::string& name,
                                                const std::filesystem::path& folder);

}  // namespace wold::povray
