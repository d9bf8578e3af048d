#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "core/ground_map.h"
#include "landscape/landscape.h"

namespace wold::povray {

/// Writes the terrain as a mesh2, `#declare Terrain = mesh2 { ... }`: every square of the map is
/// cut along the diagonal from (i, j) to (i + 1, j + 1). The name says what is in it, so frames
/// with the same ground share the file: returns "terrain_<hash>.inc". Throws FileError.
std::string write_terrain(const Heightfield& terrain, const std::filesystem::path& folder);

/// Writes a map as a df3 file: one slice of 16-bit integers whose sample (i, j) is the map's.
/// Returns the value of the largest integer. Throws FileError.
float write_factor(const FactorMap& factor, const std::filesystem::path& path);

/// Writes the light on the grass as <stem>_r.df3, <stem>_g.df3, <stem>_b.df3, each like
/// write_factor(). Returns the value of the largest integer for each channel. Throws FileError.
glm::vec3 write_light(const ColourMap& light, const std::filesystem::path& folder,
                      const std::string& stem);

/// Writes the finer pictures of the ground as ground_detail_1.exr and so on, like
/// write_map_picture(), and removes those of an earlier run. Returns what frame.inc says of them:
/// nothing without any. Throws FileError.
std::string write_ground_details(const landscape::Landscape& scene,
                                 const std::filesystem::path& folder);

/// Writes a map as an OpenEXR picture (half floats) whose pixel centres are the map's samples,
/// north at the top. Throws FileError.
void write_map_picture(const ColourMap& map, const std::filesystem::path& path);

}  // namespace wold::povray
