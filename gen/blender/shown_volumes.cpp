#include "blender/shown_volumes.h"

#include "landscape/cell_parts.h"
#include "landscape/light_on_grass.h"

namespace wold::blender {
namespace {

ShownVolume shown(const landscape::Landscape& landscape, const landscape::Cell& cell) {
  const auto volume = static_cast<std::size_t>(cell.volume);
  const int light_map = landscape::light_map_of(landscape, cell.world_from_cell);
  if (cell.part.is_whole()) return {volume, std::nullopt, light_map};
  const auto quarters = landscape::quarters_of_patch(landscape.volumes[volume].voxels.x);
  const glm::dvec2 middle = 0.5 * (cell.part.low + cell.part.high);
  const glm::bvec2 high = glm::greaterThan(middle, quarters.back().low);
  return {volume, int{high.x} + 2 * int{high.y}, light_map};
}

}  // namespace

ShownInstances<ShownVolume> shown_volumes(const landscape::Landscape& landscape) {
  std::vector<ShownVolume> of_cells;
  of_cells.reserve(landscape.cells.size());
  for (const landscape::Cell& cell : landscape.cells) of_cells.push_back(shown(landscape, cell));
  return ShownInstances(of_cells);
}

ShownInstances<ShownBlades> shown_blades(const landscape::Landscape& landscape) {
  std::vector<ShownBlades> of_cells;
  of_cells.reserve(landscape.blade_cells.size());
  for (const landscape::BladeCell& cell : landscape.blade_cells)
    of_cells.push_back({static_cast<std::size_t>(cell.mesh),
                        landscape::light_map_of(landscape, cell.world_from_cell)});
  return ShownInstances(of_cells);
}

}  // namespace wold::blender
