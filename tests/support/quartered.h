#pragma once

#include <utility>
#include <vector>

#include "landscape/cell_parts.h"
#include "landscape/landscape.h"

namespace wold::test {

/// Draws every other cell in quarters that lie as the whole did: it has to look the same.
inline void quarter_cells(landscape::Landscape& landscape) {
  std::vector<landscape::Cell> cells;
  for (std::size_t i = 0; i < landscape.cells.size(); ++i) {
    const landscape::Cell& cell = landscape.cells[i];
    if (i % 2 == 0) {
      cells.push_back(cell);
      continue;
    }
    const int voxels = landscape.volumes[static_cast<std::size_t>(cell.volume)].voxels.x;
    for (const landscape::Part& quarter : landscape::quarters_of_patch(voxels))
      cells.push_back({cell.world_from_cell, cell.volume, cell.reach, quarter});
  }
  landscape.cells = std::move(cells);
}

}  // namespace wold::test
