#include "terrain/model_lakes.h"

#include <algorithm>
#include <cmath>

#include "core/quiet_gdal.h"
#include "terrain/raster_cells.h"
#include "terrain/scene_place.h"
#include "terrain/still_water.h"
#include "terrain/thinned_cells.h"

namespace wold::terrain {
namespace {

constexpr int most_cells = 2048;  // along a side
constexpr double wider = 3.0;     // than the scene's square

/// Of two steps a cell.
GroundGrid grid_of_lakes(double size_m, double cell_m) {
  const double width_m = wider * size_m;
  const int samples =
      static_cast<int>(std::clamp(2.0 * width_m / cell_m + 1.0, 17.0, most_cells + 1.0));
  return {{glm::dvec2(-0.5 * (wider - 1.0) * size_m), width_m}, samples};
}

}  // namespace

std::optional<Lakes> model_lakes(const scene::Terrain& terrain, double zero_m) {
  const QuietGdal quiet;
  const Raster raster(terrain.elevation, terrain.system);
  const LocalSystem local = local_system(raster, middle_of(terrain, raster));
  const ThinnedCells cells =
      thinned_cells(raster, cells_under(raster, local, wider * terrain.size_m), most_cells);
  const double side_m = cells.apart * cell_m(raster, local);
  const StillWater water = still_water(cells.block, side_m);
  if (water.levels.empty()) return std::nullopt;
  const GroundGrid grid = grid_of_lakes(terrain.size_m, side_m);
  Lakes lakes{by_place<int>(cells, raster, local, grid,
                            [&](int cell) {
                              return cell < 0 ? -1 : water.lake[static_cast<std::size_t>(cell)];
                            }),
              {}};
  const HeightScale scale = raster.height_scale();
  for (const double level : water.levels) lakes.levels_m.push_back(scale.height_m(level) - zero_m);
  return lakes;
}

}  // namespace wold::terrain
