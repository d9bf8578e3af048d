#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "grass/texel/texel.h"
#include "grass/texel/volume_data.h"

namespace wold::grass {

/// The time-varying texel on disk, one file per key frame: FloatGrids `density` and `specular`,
/// Vec3SGrids `tangent`, `normal`, `albedo` and `transmittance`, all of one topology, half
/// precision. Index (1, 1, 1) is the first voxel, which leaves the one-voxel border that renderers
/// need; the grids' transform puts its centre at half a voxel. File metadata: `content` (the given
/// hash), `side`, `height`, `voxel_m`. Throws FileError.
void write_texel(const std::filesystem::path& path, const Texel& texel, const std::string& content);

/// Reads what write_texel() wrote; values come back with half precision. Throws FileError.
Texel read_texel(const std::filesystem::path& path);

/// A baked level: `density` and one `emission_q<turn>` for each of `turns`, which must be baked,
/// laid out as above.
void write_volume(const std::filesystem::path& path, const VolumeData& volume,
                  const std::set<int>& turns, const std::string& content);

/// The `content` a file was written with; empty when there is no such file or it is damaged.
std::string file_content(const std::filesystem::path& path);

/// Extent of a written texel or volume, from the file's metadata. Throws FileError.
TexelShape file_shape(const std::filesystem::path& path);

}  // namespace wold::grass
