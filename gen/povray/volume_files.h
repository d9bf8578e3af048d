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

/// Height in voxels of the lowest slices that have all of the sum but `fraction` of it at most; at
/// least 1. With 0 it is that of the last slice with a value above zero.
int filled_height(std::span<const float> values, glm::ivec3 voxels, double fraction = 0.0);

/// Of a volume's extinction, what write_texel() may leave out: the tips of a blade or two.
inline constexpr double fraction_of_tips = 0.0005;

/// The name of the extinction of a volume's files: volumes of one .vdb differ in light alone, and
/// share it.
std::string density_name(const landscape::Volume& volume);

/// Writes below `folder` what volumes of one .vdb, at least one, show:
///
///     <density>.df3                 extinction
///     <density>.inc                 its size and maximum
///     <name>_l.df3                  luminance of what it emits, extinction times radiance,
///     <name>_r.df3, _g.df3, _b.df3  colour of that, of luminance 1, at half the resolution
///                                   (landscape/emitted_light.h),
///     <name>.inc                    their maxima, for each of the volumes
///
/// in integers of 8 or 16 bits. An .inc is written after its df3 files and has the content's hash
/// and theirs; those that are as it says stay. Throws FileError.
void write_texel(std::span<const landscape::Volume* const> volumes, int bits,
                 const std::filesystem::path& folder);

/// The files of a volume, the shared ones too.
std::vector<std::filesystem::path> volume_files(const landscape::Volume& volume,
                                                const std::filesystem::path& folder);

/// Writes a cloud as <name>_d.df3 (extinction), <name>_r.df3, _g.df3, _b.df3 (extinction times
/// source radiance) and <name>.inc, always anew. Throws FileError.
void write_cloud(const landscape::CloudBox& cloud, int bits, const std::filesystem::path& folder);

/// The files of a cloud.
std::vector<std::filesystem::path> cloud_files(const landscape::CloudBox& cloud,
                                               const std::filesystem::path& folder);

}  // namespace wold::povray
