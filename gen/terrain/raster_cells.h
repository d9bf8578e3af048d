#pragma once

#include <glm/glm.hpp>

#include "terrain/local_system.h"
#include "terrain/resampling.h"

namespace wold::terrain {

/// Cells of a raster from `first` on, up to but without `end`, by column and row.
struct CellBox {
  glm::ivec2 first;
  glm::ivec2 end;

  glm::ivec2 size() const { return glm::max(end - first, 0); }
};

/// Those under the square of `size_m` about the local system's centre, and a few around it; none
/// where it lies beyond the raster.
CellBox cells_under(const Raster& raster, const LocalSystem& local, double size_m);

/// Refuses heights that are none. Those of all planets and moons with a known ground are in range;
/// what stands for a missing height without being declared as that is not. Throws InputError.
void require_heights(const Raster& raster, const CellBox& box);

/// The stored values of a box of cells, as far as it lies within the raster; those that are no
/// heights are NaN.
/// Throws InputError.
CellBlock read_cells(const Raster& raster, const CellBox& box);

}  // namespace wold::terrain
