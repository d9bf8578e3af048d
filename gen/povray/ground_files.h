#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/ground_map.h"
#include "landscape/landscape.h"

namespace wold::povray {

/// Writes the terrain as a mesh2, `#declare Wold_terrain_mesh = mesh2 { ... }`: every square of the
/// map is cut along the diagonal from (i, j) to (i + 1, j + 1). The name says what is in it, so
/// frames with the same ground share the file: returns "terrain_<hash>.inc". Throws FileError.
std::string write_terrain(const Heightfield& terrain, const std::filesystem::path& folder);

/// Writes boulders, of which there is at least one, from their origin, as
/// `#declare Wold_boulders_mesh = mesh2 { ... }`. The name says what is in it: returns
/// "boulders_<hash>.inc". Throws FileError.
std::string write_boulders(const landscape::RaisedGround& boulders,
                           const std::filesystem::path& folder);

/// The map, and its border's values a metre or so beyond it: blades hang over the terrain's edges,
/// and outside a density file all is 0.
template <class T, class Meaning>
GroundMap<T, Meaning> continued(const GroundMap<T, Meaning>& map) {
  constexpr double reach_m = 1.0;
  const double wanted = std::ceil(reach_m / map.step_m());
  const int beyond = static_cast<int>(std::min<double>(wanted, map.samples()));
  const int side = map.samples() + 2 * beyond;
  GroundMap<T, Meaning> result(
      side, Square{map.corner_m() - beyond * map.step_m(), (side - 1) * map.step_m()});
  const auto inside = [&](int i) { return std::clamp(i - beyond, 0, map.samples() - 1); };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) result.at(i, j) = map.at(inside(i), inside(j));
  return result;
}

/// Writes a map as a df3 file: one slice of 16-bit integers whose sample (i, j) is the map's.
/// Returns the value of the largest integer. Throws FileError.
float write_factor(const FactorMap& factor, const std::filesystem::path& path);

/// Writes maps of the light on the grass, coarse to fine, each like write_factor(): the first as
/// <stem>_r.df3, <stem>_g.df3 and <stem>_b.df3, the others as <stem>_1_r.df3 and so on. Removes
/// those of an earlier run. Returns the value of the largest integer for each channel, which all
/// maps share. Throws FileError.
glm::vec3 write_light(std::span<const ColourMap> maps, const std::filesystem::path& folder,
                      const std::string& stem);

/// Removes what write_light() has written of the maps of that number, from 0, and of later ones.
void remove_light(const std::filesystem::path& folder, const std::string& stem, std::size_t number);

/// The names of the files that write_light() writes of the map of that number, from 0.
std::vector<std::string> light_files(const std::string& stem, std::size_t number);

/// Writes the finer pictures of the ground as ground_detail_1.exr and so on, like
/// write_map_picture(), and removes those of an earlier run. Returns what frame.inc says of them:
/// nothing without any. Throws FileError.
std::string write_ground_details(const landscape::Landscape& scene,
                                 const std::filesystem::path& folder);

/// Writes a map as an OpenEXR picture (half floats) whose pixel centres are the map's samples,
/// north at the top. Throws FileError.
void write_map_picture(const ColourMap& map, const std::filesystem::path& path);

}  // namespace wold::povray
