#include "terrain/elevation.h"

#include <fmt/format.h>
#include <gdal_alg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/quiet_gdal.h"
#include "terrain/cell_map.h"
#include "terrain/raster_cells.h"
#include "terrain/scene_place.h"

namespace wold::terrain {
namespace {

/// A part of the square's samples, up to but without `end`.
struct Part {
  glm::ivec2 first;
  glm::ivec2 end;
};

/// The box of cells between half steps, and what cubic convolution needs around it to keep means.
CellBox cells_of(const CellMap& cells, const Part& part) {
  constexpr double around = 3.0 + 2.0 * mean_passes;
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (int j = 2 * part.first.y; j <= 2 * part.end.y; ++j)
    for (int i = 2 * part.first.x; i <= 2 * part.end.x; ++i) {
      const glm::dvec2 cell = cells.at(i, j);
      if (std::isnan(cell.x) || std::isnan(cell.y)) continue;
      low = glm::min(low, cell);
      high = glm::max(high, cell);
    }
  constexpr double max = 1e9;
  return {glm::ivec2(glm::floor(glm::clamp(low - around, -max, max))),
          glm::ivec2(glm::ceil(glm::clamp(high + around, -max, max)))};
}

/// The stored value of a sample: between the raster's cells, or the mean of those around it up to
/// half a step, where there are several.
double resampled(const CellBlock& block, const CellMap& cells, const glm::ivec2& sample,
                 bool raster_is_finer) {
  const glm::ivec2 middle = 2 * sample + 1;
  if (!raster_is_finer) return cubic_value(block, cells.at(middle.x, middle.y));
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const glm::ivec2 corner : {glm::ivec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
    const glm::dvec2 cell = cells.at(middle.x + corner.x, middle.y + corner.y);
    low = glm::min(low, cell);
    high = glm::max(high, cell);
  }
  return mean_value(block, low, high);
}

/// A raster of terrain.surroundings: in the scene's system where it does not say its own.
Raster raster_around(const std::string& file, const std::string& system) {
  constexpr const char* key = "terrain.surroundings";
  Raster raster(file, "", key);
  return raster.system() != nullptr || system.empty() ? std::move(raster)
                                                      : Raster(file, system, key);
}

/// The stored values under the square, voids as NaN, rows southwards: a raster in memory. Part by
/// part, so that of a large raster few cells are there at a time.
GDALDatasetUniquePtr stored_square(const Raster& raster, const CellMap& cells, int samples,
                                   double cells_per_step) {
  constexpr double max_cells = 2048.0;  // along a part's side
  const int side = static_cast<int>(std::clamp(max_cells / cells_per_step, 1.0, 64.0));
  GDALDatasetUniquePtr square(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", samples, samples, 1, GDT_Float64, nullptr));
  if (!square) raster.fail(CPLGetLastErrorMsg());
  GDALRasterBand& band = *square->GetRasterBand(1);
  band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  for (int y = 0; y < samples; y += side)
    for (int x = 0; x < samples; x += side) {
      const Part part{{x, y}, glm::min(glm::ivec2(x, y) + side, samples)};
      CellBlock block = read_cells(raster, cells_of(cells, part));
      if (cells_per_step <= 1.0) block = with_means_kept(block);
      for (int j = part.first.y; j < part.end.y; ++j)
        for (int i = part.first.x; i < part.end.x; ++i) {
          double value = resampled(block, cells, {i, j}, cells_per_step > 1.0);
          if (band.RasterIO(GF_Write, i, samples - 1 - j, 1, 1, &value, 1, 1, GDT_Float64, 0, 0,
                            nullptr) != CE_None)
            raster.fail(CPLGetLastErrorMsg());
        }
    }
  return square;
}

/// Row by row from the north-west corner.
std::vector<double> values_of(GDALRasterBand& band) {
  const int columns = band.GetXSize();
  const int rows = band.GetYSize();
  std::vector<double> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (band.RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float64, 0, 0,
                    nullptr) != CE_None)
    throw InputError(fmt::format("terrain.elevation: {}", CPLGetLastErrorMsg()));
  return values;
}

std::size_t count_voids(const std::vector<double>& values) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return std::isnan(value); }));
}

/// Of what was filled in: inverse distances alone leave steps where their nearest neighbours
/// change.
constexpr int smoothing_passes = 50;

/// The square's stored values without voids.
std::vector<double> filled_values(const Raster& raster, GDALRasterBand& band,
                                  const glm::dvec2& centre, const LocalSystem& local,
                                  double size_m) {
  std::vector<double> values = values_of(band);
  const std::size_t voids = count_voids(values);
  if (voids == 0) return values;
  if (2 * voids >= values.size()) {
    const double covered = covered_m(raster, local, size_m);
    raster.fail(fmt::format(
        "{:.0f} % of the {} m (terrain.size) around [{:.10g}, {:.10g}] (terrain.centre) have no "
        "height: the model reaches {}{}{}",
        100.0 * static_cast<double>(voids) / static_cast<double>(values.size()), size_m, centre.x,
        centre.y, raster.extent(),
        covered > 0.0 ? fmt::format("; it covers {:.3g} m around that place", covered) : "",
        raster.degrees_hint()));
  }
  const double farthest = 2.0 * band.GetXSize();
  // Otherwise it works in files of the current folder.
  std::string in_memory = "TEMP_FILE_DRIVER=MEM";
  std::array<char*, 2> options = {in_memory.data(), nullptr};
  if (GDALFillNodata(&band, nullptr, farthest, 0, smoothing_passes, options.data(), nullptr,
                     nullptr) != CE_None)
    raster.fail(CPLGetLastErrorMsg());
  return values_of(band);
}

/// Values on the ground, from the south-west, of a raster's rows from the north-west.
template <class Value, class Convert>
void turn_over(const std::vector<double>& rows, GroundMap<Value>& map, const Convert& convert) {
  auto from = rows.begin();
  for (int j = map.samples() - 1; j >= 0; --j)
    for (int i = 0; i < map.samples(); ++i) map.at(i, j) = convert(*from++);
}

/// Refuses degrees that were taken for metres: a landscape much higher than wide.
void require_slopes(const Raster& raster, double rise_m, double size_m) {
  constexpr double steepest = 10.0;
  if (rise_m > steepest * size_m && raster.looks_like_degrees())
    raster.fail(fmt::format("the ground rises by {:.4g} m within {:.4g} m (terrain.size){}", rise_m,
                            size_m, raster.degrees_hint()));
}

}  // namespace

Elevation read_elevation(const scene::Terrain& terrain) {
  const QuietGdal quiet;
  const Raster raster(terrain.elevation, terrain.system);
  const int samples = terrain.samples;
  const double size_m = terrain.size_m;
  const glm::dvec2 middle = middle_of(terrain, raster);
  const LocalSystem local = local_system(raster, middle);
  Elevation elevation{GroundMap<double>(samples, size_m), cell_m(raster, local), 0.0};
  require_heights(raster, cells_under(raster, local, size_m));
  const Transformer transformer(raster, local);
  const CellMap cells = cells_about(transformer, local, samples, size_m);
  const GDALDatasetUniquePtr square =
      stored_square(raster, cells, samples, elevation.heights_m.step_m() / elevation.cell_m);
  const std::vector<double> stored =
      filled_values(raster, *square->GetRasterBand(1), middle, local, size_m);
  const HeightScale scale = raster.height_scale();
  const auto [low, high] = std::ranges::minmax_element(stored);
  // A scale may be negative.
  const double lowest_m = std::min(scale.height_m(*low), scale.height_m(*high));
  const double highest_m = std::max(scale.height_m(*low), scale.height_m(*high));
  require_slopes(raster, highest_m - lowest_m, size_m);
  elevation.zero_m = lowest_m;
  turn_over(stored, elevation.heights_m,
            [&](double value) { return scale.height_m(value) - lowest_m; });
  return elevation;
}

double elevation_cell_m(const scene::Terrain& terrain) {
  const QuietGdal quiet;
  const Raster raster(terrain.elevation, terrain.system);
  return cell_m(raster, local_system(raster, middle_of(terrain, raster)));
}

bool elevation_looks_like_degrees(const scene::Terrain& terrain) {
  const QuietGdal quiet;
  return Raster(terrain.elevation, terrain.system).looks_like_degrees();
}

GroundMap<double> heights_around(const scene::Terrain& terrain, const std::string& file,
                                 const GroundGrid& grid) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  constexpr double max_cells = 1 << 27;
  const QuietGdal quiet;
  const Raster centre(terrain.elevation, terrain.system);
  const LocalSystem local = local_system(centre, middle_of(terrain, centre));
  const Raster raster = file == terrain.elevation ? Raster(file, terrain.system)
                                                  : raster_around(file, terrain.system);
  if (local.definition.empty() != (raster.system() == nullptr))
    raster.fail(
        "expected a coordinate system where terrain.elevation has one, and none where it has none");
  GroundMap<double> heights_m(grid.samples, grid.square, nothing);
  const glm::dvec2 covered(cells_under(raster, local, grid.square.size_m).size());
  if (covered.x * covered.y > max_cells) return heights_m;
  const Transformer transformer(raster, local);
  const GDALDatasetUniquePtr square =
      stored_square(raster, cells_about(transformer, local, grid.samples, grid.square.size_m),
                    grid.samples, grid.step_m() / cell_m(raster, local));
  const HeightScale scale = raster.height_scale();
  turn_over(values_of(*square->GetRasterBand(1)), heights_m,
            [&](double value) { return scale.height_m(value); });
  return heights_m;
}

}  // namespace wold::terrain
