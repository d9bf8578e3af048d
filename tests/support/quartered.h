#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "landscape/cell_parts.h"
#include "landscape/landscape.h"

namespace wold::test {

/// A part in two, at a border of voxels.
inline std::array<landscape::Part, 2> halves_of(const landscape::Part& part, int voxels) {
  const double border = std::round((part.low.x + part.high.x) / 2.0 * voxels) / voxels;
  return {landscape::Part{part.low, {border, part.high.y}},
          landscape::Part{{border, part.low.y}, part.high}};
}

/// Draws every other cell in quarters, the last of them in halves, that lie as the whole did: it
/// has to look the same.
inline void quarter_cells(landscape::Landscape& landscape) {
  std::vector<landscape::Cell> cells;
  for (std::size_t i = 0; i < landscape.cells.size(); ++i) {
    const landscape::Cell& cell = landscape.cells[i];
    if (i % 2 == 0) {
      cells.push_back(cell);
      continue;
    }
    const int voxels = landscape.volumes[static_cast<std::size_t>(cell.volume)].voxels.x;
    const auto quarters = landscape::quarters_of_patch(voxels);
    std::vector<landscape::Part> parts(quarters.begin(), quarters.end() - 1);
    for (const landscape::Part& half : halves_of(quarters.back(), voxels)) parts.push_back(half);
    for (const landscape::Part& part : parts)
      cells.push_back({cell.world_from_cell, cell.volume, cell.reach, part});
  }
  landscape.cells = std::move(cells);
}

}  // namespace wold::test
