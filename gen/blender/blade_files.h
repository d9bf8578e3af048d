#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "landscape/landscape.h"

namespace wold::blender {

/// Writes a mesh of blades as raw little-endian arrays:
///   NAME.vertices.f32  3 per vertex, metres
///   NAME.radiance.f32  3 per vertex
///   NAME.quads.i32     4 per face: indices of its corners
/// The name says what is in them: what is there already stays. Throws FileError.
void write_blades(const landscape::BladeMesh& mesh, const std::filesystem::path& folder);

/// The files of a mesh of that name.
std::vector<std::filesystem::path> blade_files(const std::string& name,
                                               const std::filesystem::path& folder);

}  // namespace wold::blender
