#pragma once

#include "scene/scene.h"
#include "terrain/cell_map.h"
#include "terrain/local_system.h"
#include "terrain/raster.h"

namespace wold::terrain {

/// Where the scene's middle lies, in the coordinates of the raster of terrain.elevation.
inline glm::dvec2 middle_of(const scene::Terrain& terrain, const Raster& raster) {
  return terrain.centre.empty() ? raster.middle()
                                : glm::dvec2(terrain.centre[0], terrain.centre[1]);
}

/// The cells of a raster under a square about the local system's centre; the transformer has to
/// outlive it.
inline CellMap cells_about(const Transformer& transformer, const LocalSystem& local, int samples,
                           double size_m) {
  return {[&transformer, centre = local.centre](const glm::dvec2& from_middle_m) {
            return transformer.cell_at(centre + from_middle_m);
          },
          samples, size_m};
}

}  // namespace wold::terrain
