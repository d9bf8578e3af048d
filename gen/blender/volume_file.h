#pragma once

#include <filesystem>

#include "blender/colour_picture.h"
#include "landscape/landscape.h"

namespace wold::blender {

/// What density and emission of a grass volume are counted in, so that all of it is less than
/// 1: below that, Cycles can be told to take no voxel for a reason to look there.
constexpr float density_unit_per_m = 4096.0F;

/// Writes a volume as Cycles reads it, in half precision (error below 0.05 % or 0.0002/m):
///   `density`    extinction in density_unit_per_m,
///   `emission`   density times luminance of the source radiance: what a ray's luminance gains. The
///                product is stored, since interpolating the two apart darkens every edge,
///   `quarter 0`  to 3, in the order of landscape::quarters_of_patch(): truth values, active in
///                just those of OpenVDB's leaves of which the quarter consists. Cycles builds a
///                hull for each, while all of them share the volume in memory.
/// Voxels of no density are left out, so that Cycles steps over them. So are the highest layers,
/// the tips of a blade or two, that have 0.05 % of the extinction. The volume ends one voxel above
/// the rest. The colour of what is emitted goes into colour_file(), a PNG of 8 bits beside it at
/// half the resolution. A file remembers the volume's content; one that is there with the same
/// content stays. Throws FileError.
ColourPicture write_volume(const std::filesystem::path& path, const landscape::Volume& volume);

/// The picture of a volume's colours.
std::filesystem::path colour_file(const std::filesystem::path& volume_file);

/// Writes a cloud as Cycles reads it, in half precision, replacing the file: `density`, its
/// extinction per metre, and `emission red`, `emission green` and `emission blue`, what a ray gains
/// per metre. A grid of vectors would take the memory of four numbers. Throws FileError.
void write_cloud(const std::filesystem::path& path, const landscape::CloudBox& cloud);

}  // namespace wold::blender
