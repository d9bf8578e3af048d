#pragma once

#include <filesystem>

#include "grass/texel/texel.h"

namespace wold::grass {

/// Most voxels along an edge of a texel that is read, and most of them that hold matter.
inline constexpr int max_texel_side = 1024;
inline constexpr std::size_t max_texel_voxels = 20'000'000;

/// A texel from any .vdb: one that write_texel() wrote, or a fog volume of cubic voxels with a
/// FloatGrid `density`, projected area per volume, z up. Its lowest voxels stand on the ground, its
/// longer side is that of the tile. Vec3SGrids `tangent`, `normal` and `albedo` and a FloatGrid
/// `specular` of the same voxels are taken where they are there; without them fibres stand upright
/// and are mesophyll, and the texel's `albedo` is empty. Lengths are the file's.
///
/// Throws FileError when the file is missing or damaged and InputError, which names `key`, when it
/// is something else: no density, a level set, empty, too large, not cubic, not finite.
Texel read_any_texel(const std::filesystem::path& path, const char* key);

/// The texel grown or shrunk evenly to a patch of that side; optical depths stay.
Texel fitted_to_patch(Texel texel, double patch_m);

}  // namespace wold::grass
