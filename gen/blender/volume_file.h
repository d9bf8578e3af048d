#pragma once

#include <filesystem>

#include "landscape/landscape.h"

namespace wold::blender {

/// What density and emission of a grass volume are counted in, so that all of it is less than
/// 1: below that, Cycles can be told to take no voxel for a reason to look there.
constexpr float density_unit_per_m = 4096.0F;

/// Writes a volume as Cycles reads it, in half precision (error below 0.05 % or 0.0002/m):
///   `density`    extinction in density_unit_per_m,
///   `emission red`, `emission green`, `emission blue`   density times source radiance: what a
///                ray's radiance gains. The product is stored, since interpolating the two apart
///                darkens every edge. A vector would take the memory of four numbers,
///   `quarter 0`  to 3, in the order of landscape::quarters_of_patch(): truth values, active in
///                just those of OpenVDB's leaves of which the quarter consists. Cycles builds a
///                hull for each, while all of them share the volume in memory.
/// Voxels of no density are left out, so that Cycles steps over them. So are the highest layers,
/// the tips of a blade or two, that have 0.05 % of the extinction. The volume ends one voxel above
/// the rest. A file remembers the volume's content; one that is there with the same content stays.
/// Throws FileError.
void write_volume(const std::filesystem::path& path, const landscape::Volume& volume);

/// Writes a cloud likewise, but per metre, without quarters and always anew.
void write_cloud(const std::filesystem::path& path, const landscape::CloudBox& cloud);

}  // namespace wold::blender
