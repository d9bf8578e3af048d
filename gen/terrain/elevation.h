#pragma once

#include <string>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::terrain {

/// A real place's heights and how finely they were measured.
struct Elevation {
  GroundMap<double> heights_m;  ///< above the lowest point of the square
  double cell_m = 0.0;          ///< side of the raster's cells on the ground
  double zero_m = 0.0;          ///< height of the lowest point, over the raster's own zero
};

/// The square of terrain.size_m around a place of the elevation model terrain.elevation, a file of
/// one of elevation_drivers, with terrain.samples heights per side.
///
/// terrain.centre is that place in the raster's own coordinates, east and north: degrees for a
/// geographic raster, mostly metres for a projected one; empty: the raster's middle. The square
/// lies in an azimuthal equidistant projection about its centre, so its metres are metres on the
/// ground whatever the raster's system, and its y is north. terrain.system is the raster's system
/// and wins over what the file says; a raster without either is taken as metres. Heights between
/// the raster's are cubic, with the raster's as means of its cells; where the raster is the finer
/// one, they are means of it. The band's scale,
/// offset and unit (feet) are heeded. Voids are filled from around them, so that no void is a
/// cliff.
///
/// Throws InputError when the file is no raster that lies somewhere, has a height under the square
/// that is not finite or not between -12 and 30 km (with its row and column), has more than 2^30
/// cells there, or half of the square or more lies beyond its heights; the message says where the
/// raster is, and names terrain.system when its coordinates look like degrees. Throws InputError
/// when nobody knows terrain.system.
Elevation read_elevation(const scene::Terrain& terrain);

/// Side of a cell of terrain.elevation on the ground about terrain.centre, metres. Reads no height.
/// Throws InputError when the file is no raster that lies somewhere, or when nobody knows
/// terrain.system.
double elevation_cell_m(const scene::Terrain& terrain);

/// Whether terrain.elevation does not say its coordinate system, nor does terrain.system, and its
/// coordinates look like degrees: they are taken for metres. Throws InputError when the file is no
/// raster that lies somewhere.
bool elevation_looks_like_degrees(const scene::Terrain& terrain);

/// Heights on a grid about the same place, metres above the file's own zero: of terrain.elevation,
/// or of another model, `file`, whose place its own coordinate system tells. NaN where the model
/// has none, or where the grid covers so much of it (2^27 cells) that reading it would take long.
///
/// Throws InputError when a file is no raster that lies somewhere, or when one of the two has a
/// coordinate system and the other has none.
GroundMap<double> heights_around(const scene::Terrain& terrain, const std::string& file,
                                 const GroundGrid& grid);

}  // namespace wold::terrain
