#include "blender/shown_volumes.h"

#include <algorithm>

#include "landscape/cell_parts.h"

namespace wold::blender {
namespace {

ShownVolume shown(const landscape::Landscape& landscape, const landscape::Cell& cell) {
  const auto volume = static_cast<std::size_t>(cell.volume);
  if (cell.part.is_whole()) return {volume, std::nullopt};
  const auto quarters = landscape::quarters_of_patch(landscape.volumes[volume].voxels.x);
  const glm::dvec2 middle = 0.5 * (cell.part.low + cell.part.high);
  const glm::bvec2 high = glm::greaterThan(middle, quarters.back().low);
  return {volume, int{high.x} + 2 * int{high.y}};
}

}  // namespace

ShownVolumes::ShownVolumes(const landscape::Landscape& landscape) {
  std::vector<ShownVolume> of_cells;
  for (const landscape::Cell& cell : landscape.cells) of_cells.push_back(shown(landscape, cell));
  all_ = of_cells;
  std::ranges::sort(all_);
  all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
  for (const ShownVolume& each : of_cells)
    picks_.push_back(static_cast<int>(std::ranges::lower_bound(all_, each) - all_.begin()));
}

}  // namespace wold::blender
