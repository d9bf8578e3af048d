#include "terrain/raster_cells.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace wold::terrain {
namespace {

constexpr double lowest_m = -12000.0, highest_m = 30000.0;
constexpr double usual_void = -9999.0;  // it would pass for a depth of the sea

/// Whether a stored value can be a height: those of all planets and moons with a known ground can.
bool is_height(double stored, const HeightScale& scale) {
  const double height_m = scale.height_m(stored);
  return height_m >= lowest_m && height_m <= highest_m && stored != usual_void;
}

}  // namespace

CellBox cells_under(const Raster& raster, const LocalSystem& local, double size_m) {
  constexpr int steps = 20;
  constexpr double around = 4.0;
  const Transformer transformer(raster, local);
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      const glm::dvec2 from_centre_m = (glm::dvec2(i, j) / (1.0 * steps) - 0.5) * size_m;
      const auto cell = transformer.cell_at(local.centre + from_centre_m);
      if (!cell) continue;
      low = glm::min(low, *cell - around);
      high = glm::max(high, *cell + around);
    }
  const glm::dvec2 all(raster.dataset().GetRasterXSize(), raster.dataset().GetRasterYSize());
  return {glm::ivec2(glm::clamp(low, glm::dvec2(0.0), all)),
          glm::ivec2(glm::clamp(high, glm::dvec2(0.0), all))};
}

void require_heights(const Raster& raster, const CellBox& box) {
  constexpr double max_cells = 1 << 30;
  const glm::ivec2 size = box.size();
  if (1.0 * size.x * size.y > max_cells)
    raster.fail(
        fmt::format("the square (terrain.size) covers {} x {} of its cells, expected {} "
                    "at most: take a smaller square or a coarser model",
                    size.x, size.y, max_cells));
  GDALRasterBand& band = *raster.dataset().GetRasterBand(1);
  const HeightScale scale = raster.height_scale();
  std::vector<double> values(static_cast<std::size_t>(size.x));
  std::vector<std::uint8_t> there(values.size());
  const auto read_row = [&](GDALRasterBand& from, int row, void* into, GDALDataType type) {
    if (from.RasterIO(GF_Read, box.first.x, row, size.x, 1, into, size.x, 1, type, 0, 0, nullptr) !=
        CE_None)
      raster.fail(CPLGetLastErrorMsg());
  };
  for (int row = box.first.y; size.x > 0 && row < box.end.y; ++row) {
    read_row(band, row, values.data(), GDT_Float64);
    read_row(*band.GetMaskBand(), row, there.data(), GDT_Byte);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (there[i] != 0 && !is_height(values[i], scale))
        raster.fail(fmt::format(
            "row {}, column {}: found {}, expected a height from {} to {} m; if it stands for a "
            "missing height, the file has to say so (gdal_edit.py -a_nodata {})",
            row + 1, box.first.x + static_cast<int>(i) + 1, values[i], lowest_m, highest_m,
            values[i]));
    }
  }
}

CellBlock read_cells(const Raster& raster, const CellBox& box) {
  const glm::ivec2 all(raster.dataset().GetRasterXSize(), raster.dataset().GetRasterYSize());
  CellBlock block;
  block.first = glm::clamp(box.first, glm::ivec2(0), all);
  block.size = glm::clamp(box.end, block.first, all) - block.first;
  if (block.size.x == 0 || block.size.y == 0) return block;
  block.values.resize(static_cast<std::size_t>(block.size.x) *
                      static_cast<std::size_t>(block.size.y));
  std::vector<std::uint8_t> there(block.values.size());
  GDALRasterBand& band = *raster.dataset().GetRasterBand(1);
  const auto read = [&](GDALRasterBand& from, void* into, GDALDataType type) {
    if (from.RasterIO(GF_Read, block.first.x, block.first.y, block.size.x, block.size.y, into,
                      block.size.x, block.size.y, type, 0, 0, nullptr) != CE_None)
      raster.fail(CPLGetLastErrorMsg());
  };
  read(band, block.values.data(), GDT_Float64);
  read(*band.GetMaskBand(), there.data(), GDT_Byte);
  const HeightScale scale = raster.height_scale();
  for (std::size_t i = 0; i < there.size(); ++i)
    if (there[i] == 0 || !is_height(block.values[i], scale))
      block.values[i] = std::numeric_limits<double>::quiet_NaN();
  return block;
}

}  // namespace wold::terrain
