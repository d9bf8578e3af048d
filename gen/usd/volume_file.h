#pragma once

#include <filesystem>
#include <string>

#include "landscape/landscape.h"

namespace wold::usd {

/// The name of a texel's file: the same for all volumes of the same content.
std::string volume_name(const landscape::Volume& volume);

/// Writes NAME.vdb below `folder`, as hosts read it from an OpenVDBAsset:
///   `density`   FloatGrid of half floats, extinction in 1/m
///   `emission`  Vec3SGrid, density times source radiance: what a ray gains per metre
/// The grids' transform is cell space in metres, values at voxels' centres. What is there already
/// stays. Throws FileError.
void write_volume(const landscape::Volume& volume, const std::filesystem::path& folder);

/// Writes a cloud with the grids of write_volume(), their transform being metres from its corner. A
/// file that is there is replaced. Throws FileError.
void write_cloud(const std::filesystem::path& path, const landscape::CloudBox& cloud);

}  // namespace wold::usd
