#include "terrain/thinned_cells.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace wold::terrain {

int ThinnedCells::index(const glm::dvec2& raster_cell) const {
  const glm::dvec2 cell = glm::floor((raster_cell - glm::dvec2(block.first)) / apart);
  const bool is_inside = glm::all(glm::greaterThanEqual(cell, glm::dvec2(0.0))) &&
                         glm::all(glm::lessThan(cell, glm::dvec2(block.size)));
  return is_inside ? static_cast<int>(cell.y) * block.size.x + static_cast<int>(cell.x) : -1;
}

ThinnedCells thinned_cells(const Raster& raster, const CellBox& box, int most) {
  const glm::ivec2 all = box.size();
  const double apart = std::max(1.0, std::ceil(1.0 * std::max(all.x, all.y) / most));
  const glm::ivec2 size(glm::floor(glm::dvec2(all) / apart));
  ThinnedCells cells{{box.first, size, {}}, apart};
  if (size.x <= 0 || size.y <= 0) return cells;
  const glm::ivec2 covered = size * static_cast<int>(apart);
  std::vector<double>& values = cells.block.values;
  values.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  std::vector<std::uint8_t> there(values.size());
  const auto read = [&](GDALRasterBand& from, void* into, GDALDataType type) {
    if (from.RasterIO(GF_Read, box.first.x, box.first.y, covered.x, covered.y, into, size.x, size.y,
                      type, 0, 0, nullptr) != CE_None)
      raster.fail(CPLGetLastErrorMsg());
  };
  GDALRasterBand& band = *raster.dataset().GetRasterBand(1);
  read(band, values.data(), GDT_Float64);
  read(*band.GetMaskBand(), there.data(), GDT_Byte);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (there[i] == 0) values[i] = std::numeric_limits<double>::quiet_NaN();
  return cells;
}

}  // namespace wold::terrain
