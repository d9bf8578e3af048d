#pragma once

#include <filesystem>
#include <vector>

#include "core/ground_map.h"

namespace wold::terrain {

/// A real place's heights and how finely they were measured.
struct Elevation {
  GroundMap<double> heights_m;  ///< above the lowest point of the square
  double cell_m = 0.0;          ///< side of the raster's cells on the ground
};

/// The square of `size_m` around a place of an elevation model, a file of one of
/// elevation_drivers, with `samples` heights per side.
///
/// `centre` is that place in the raster's own coordinates, east and north: degrees for a geographic
/// raster, mostly metres for a projected one; empty: the raster's middle. The square lies in an
/// azimuthal equidistant projection about its centre, so its metres are metres on the ground
/// whatever the raster's system, and its y is north; a raster without a system is taken as metres.
/// Heights between the raster's are cubic; where the raster is the finer one, they are means. The
/// band's scale, offset and unit (feet) are heeded. Voids are filled from around them, so that no
/// void is a cliff.
///
/// Throws InputError when the file is no raster that lies somewhere, has a height under the square
/// that is not finite or not between -12 and 30 km (with its row and column), has more than 2^30
/// cells there, or half of the square or more
/// lies beyond its heights; the message says where the raster is.
Elevation read_elevation(const std::filesystem::path& file, const std::vector<double>& centre,
                         int samples, double size_m);

}  // namespace wold::terrain
