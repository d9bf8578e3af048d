#pragma once

#include <filesystem>
#include <string>

#include "core/ground_map.h"

namespace wold::maps {

/// Where the scene's ground lies.
struct Georeference {
  std::string system;            ///< PROJ's definition; empty: metres of nobody's
  glm::dvec2 south_west_m{0.0};  ///< the scene's corner in that system, east and north
};

/// That of a scene: about its middle in the azimuthal equidistant projection that it is made in,
/// where terrain.elevation has a coordinate system; in the model's own coordinates where it has
/// none; from [0, 0] on where there is no model. Throws InputError.
Georeference georeference(const std::string& elevation, const std::string& system,
                          const std::vector<double>& centre, double size_m);

/// What a map's values are.
struct Quantity {
  const char* name;
  const char* unit;  ///< "" for fractions
};

/// Writes a map as a GeoTIFF of 32-bit floats, whole or not at all, with its northern row first. A
/// pixel's middle is where the map has its value, so that the picture is a step wider than the
/// ground. `source` is written into it. Throws FileError.
void write_geotiff(const std::filesystem::path& file, const FactorMap& map,
                   const Georeference& place, const Quantity& quantity, const std::string& source);

/// What write_geotiff() has written into a file as its source; empty when the file is not there or
/// is none of those.
std::string source_of_geotiff(const std::filesystem::path& file);

}  // namespace wold::maps
