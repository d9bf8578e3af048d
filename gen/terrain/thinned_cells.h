#pragma once

#include <cmath>
#include <cstddef>

#include "core/ground_map.h"
#include "terrain/cell_map.h"
#include "terrain/raster_cells.h"
#include "terrain/scene_place.h"

namespace wold::terrain {

/// Cells of a box of a raster as they are stored, of every `apart` columns and rows one; voids are
/// NaN.
struct ThinnedCells {
  CellBlock block;     ///< `first` in cells of the raster
  double apart = 1.0;  ///< in cells of the raster

  /// Index of the value at a place of the raster, in cells from its upper left corner; -1 where
  /// there is none.
  int index(const glm::dvec2& raster_cell) const;
};

/// So thin that it has `most` cells along a side at the most. Throws InputError.
ThinnedCells thinned_cells(const Raster& raster, const CellBox& box, int most);

/// A map of what `value_of(index of the cell, or -1)` says of the cell under each place of a grid,
/// about the middle of the local system.
template <class Value, class ValueOf>
GroundMap<Value> by_place(const ThinnedCells& cells, const Raster& raster, const LocalSystem& local,
                          const GroundGrid& grid, const ValueOf& value_of) {
  const Transformer transformer(raster, local);
  const CellMap places = cells_about(transformer, local, grid.samples, grid.square.size_m);
  GroundMap<Value> map(grid.samples, grid.square);
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i) {
      const glm::dvec2 at = places.at(2 * i + 1, 2 * j + 1);
      const bool is_none = std::isnan(at.x) || std::isnan(at.y);
      map.at(i, j) = value_of(is_none ? -1 : cells.index(at));
    }
  return map;
}

}  // namespace wold::terrain
