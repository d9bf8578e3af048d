#pragma once

#include <filesystem>
#include <vector>

#include "landscape/landscape.h"

namespace wold::blender {

/// The file of a part of a volume.
std::filesystem::path volume_file(const std::filesystem::path& folder,
                                  const landscape::Volume& volume, const landscape::Part& part);

/// Writes parts of a volume as Cycles reads them, a file for each, in half precision (error below
/// 0.05 %):
///   `density`   extinction in 1/m,
///   `emission`  density times source radiance: what a ray's radiance gains per metre. The product
///               is stored, since interpolating the two apart darkens every edge.
/// Voxels have the same indices in all parts; where parts touch each fades over one voxel while the
/// other comes up, so that side by side they show what the volume does. Voxels of no density are
/// left out, so that Cycles steps over them, and a part ends one voxel above its highest density. A
/// file remembers the volume's content; one that is there with the same content stays. Throws
/// FileError.
void write_volume(const std::filesystem::path& folder, const landscape::Volume& volume,
                  const std::vector<landscape::Part>& parts);

/// Writes a cloud likewise, always anew.
void write_cloud(const std::filesystem::path& path, const landscape::CloudBox& cloud);

}  // namespace wold::blender
