#pragma once

#include <vector>

#include "terrain/resampling.h"

namespace wold::terrain {

/// Still water among the cells of an elevation model.
struct StillWater {
  std::vector<int> lake;       ///< of each cell: index into `levels`; -1 is land
  std::vector<double> levels;  ///< stored values
};

/// Cells of `cell_m` that are a water surface. Makers of elevation models give each lake one
/// height, that of the lowest shore (SRTM's finished data: [SRTMWater]), while land is hardly ever
/// that even. A lake is a set of cells of the very same value, neighbours by their sides, that
/// - has 16 cells and 400 m2 or more, three by three of them in one place,
/// - has a shore of which at most a twentieth is lower than it: its outlet.
/// Models in whole steps have terraces on gentle ground: where the shore stands less than two steps
/// above it on average, a lake has 200 cells, seven by seven in one place, and a shore on all
/// sides, but where it is the sea, at 0.
StillWater still_water(const CellBlock& cells, double cell_m);

}  // namespace wold::terrain
