#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace wold::terrain {

/// What the header of an elevation model says: how a scene can show it.
struct ElevationModel {
  std::string system;   ///< for terrain.system: "EPSG:4326" where the file does not say its system
                        ///< and its coordinates look like degrees; else empty
  double cell_m = 0.0;  ///< side of its cells on the ground about its middle
  double square_m = 0.0;  ///< side of the largest square about its middle that it covers, less what
                          ///< is beyond three digits; at most terrain.size's largest
  std::optional<glm::dvec2> longitude_latitude_deg = {};  ///< of its middle, if its system is known
};

/// Reads no height. Throws InputError when the file is no raster that lies somewhere.
ElevationModel describe_elevation(const std::filesystem::path& file);

}  // namespace wold::terrain
