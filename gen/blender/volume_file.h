#pragma once

#include <filesystem>

#include "landscape/landscape.h"

namespace wold::blender {

/// Writes a volume as Cycles reads it, in half precision (error below 0.05 %):
///   `density`   extinction in 1/m,
///   `emission`  density times source radiance: what a ray's radiance gains per metre. The product
///               is stored, since interpolating the two apart darkens every edge.
/// Voxels of no density are left out, so that Cycles steps over them. The file remembers the
/// volume's content; one that is there with the same content stays. Throws FileError.
void write_volume(const std::filesystem::path& path, const landscape::Volume& volume);

/// Writes a cloud likewise, always anew.
void write_cloud(const std::filesystem::path& path, const landscape::CloudBox& cloud);

}  // namespace wold::blender
