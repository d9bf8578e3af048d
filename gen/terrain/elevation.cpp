#include "terrain/elevation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "core/elementary.h"
#include "core/error.h"
#include "core/files.h"
#include "core/quiet_gdal.h"
#include "terrain/cell_map.h"
#include "terrain/resampling.h"

namespace wold::terrain {
namespace {

struct HeightScale {
  double factor;
  double offset_m;
  double height_m(double stored) const { return factor * stored + offset_m; }
};

/// A raster that lies somewhere on the ground.
class Raster {
 public:
  /// `system`: its coordinate system, "EPSG:4326"; empty: as the file says.
  Raster(const std::filesystem::path& file, const std::string& system)
      : file_(file.string()), dataset_(open(file)), given_(system) {
    if (!dataset_)
      fail(fmt::format("expected an elevation model of one of these kinds: {}: {}",
                       fmt::join(elevation_drivers, ", "), CPLGetLastErrorMsg()));
    if (dataset_->GetRasterCount() == 0) fail("it has no band of numbers");
    if (dataset_->GetGeoTransform(transform_.data()) != CE_None)
      fail("it does not say where on the ground it lies (no geotransform)");
    require_place();
    require_rows_of_text();
    if (!given_.empty()) take_system();
    require_extent();
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(fmt::format("terrain.elevation: {}: {}", file_, reason));
  }

  GDALDataset& dataset() const { return *dataset_; }
  const OGRSpatialReference* system() const {
    return given_.empty() ? dataset_->GetSpatialRef() : &given_system_;
  }
  /// What wins over the file's own; empty: nothing.
  const std::string& given_system() const { return given_; }
  bool is_geographic() const { return system() != nullptr && system()->IsGeographic() != 0; }

  /// Where a place of the raster lies, from its upper left corner in cells.
  glm::dvec2 place(double column, double row) const {
    const auto& t = transform_;
    return {t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]};
  }
  glm::dvec2 middle() const {
    return place(dataset_->GetRasterXSize() / 2.0, dataset_->GetRasterYSize() / 2.0);
  }

  /// Whether coordinates that nobody names lie on a globe's, with cells much too fine for metres.
  bool looks_like_degrees() const {
    constexpr double coarsest_cell = 0.1;  // 11 km; grids of metres are coarser than a decimetre
    if (system() != nullptr) return false;
    const auto [low, high] = corners();
    const auto& t = transform_;
    return low.x >= -180.0 && high.x <= 360.0 && low.y >= -90.0 && high.y <= 90.0 &&
           std::max(math::hypot(t[1], t[4]), math::hypot(t[2], t[5])) < coarsest_cell;
  }

  /// What to do about that, as the end of a message.
  std::string degrees_hint() const {
    if (!looks_like_degrees()) return "";
    return "; the file does not say its coordinate system and is taken for metres, but looks like "
           "degrees: set terrain.system = \"EPSG:4326\"";
  }

  /// "from 376313 to 412223 east and from ... north"
  std::string extent() const {
    const auto [low, high] = corners();
    const char* unit = is_geographic() ? " degrees" : "";
    return fmt::format("from {:.10g} to {:.10g}{} east and from {:.10g} to {:.10g}{} north", low.x,
                       high.x, unit, low.y, high.y, unit);
  }

  /// How the stored values are metres.
  HeightScale height_scale() const {
    GDALRasterBand& band = *dataset_->GetRasterBand(1);
    const std::string unit = band.GetUnitType();
    const bool feet = unit == "ft" || unit == "feet" || unit == "foot" || unit == "us-ft" ||
                      unit == "US survey foot";
    const double unit_m = feet ? 0.3048 : 1.0;
    return {band.GetScale() * unit_m, band.GetOffset() * unit_m};
  }

 private:
  struct Corners {
    glm::dvec2 low, high;
  };
  Corners corners() const {
    const double columns = dataset_->GetRasterXSize();
    const double rows = dataset_->GetRasterYSize();
    Corners box{place(0, 0), place(0, 0)};
    for (const glm::dvec2& corner : {place(columns, 0), place(0, rows), place(columns, rows)})
      box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    return box;
  }

  void take_system() {
    constexpr std::size_t number = 5;  // after "EPSG:"
    if (given_system_.importFromEPSG(std::stoi(given_.substr(number))) != OGRERR_NONE)
      throw InputError(
          fmt::format("terrain.system: found {}, expected the number of a coordinate system: {}",
                      given_, CPLGetLastErrorMsg()));
    if (given_system_.IsGeographic() == 0 && given_system_.IsProjected() == 0)
      throw InputError(fmt::format(
          "terrain.system: found {}, {}, expected a system of degrees or of metres on the ground",
          given_, given_system_.GetName()));
  }

  /// By the absolute path, which GDAL cannot take for anything but a file's.
  static GDALDatasetUniquePtr open(const std::filesystem::path& file) {
    require_regular_file(file);
    return GDALDatasetUniquePtr(GDALDataset::Open(std::filesystem::absolute(file).c_str(),
                                                  GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
  }

  void require_place() const {
    const auto& t = transform_;
    const bool finite = std::all_of(t.begin(), t.end(), [](double x) { return std::isfinite(x); });
    if (!finite || t[1] * t[5] - t[2] * t[4] == 0.0)
      fail(fmt::format("found cells of {} x {} at [{}, {}], expected a place and a size", t[1],
                       t[5], t[0], t[3]));
    const HeightScale scale = height_scale();
    if (!std::isfinite(scale.factor) || scale.factor == 0.0 || !std::isfinite(scale.offset_m))
      fail(fmt::format("found heights scaled by {} and moved by {} m, expected finite numbers",
                       scale.factor, scale.offset_m));
  }

  /// PROJ 9.1 crashes where it is asked about places far outside of the world.
  void require_extent() const {
    constexpr glm::dvec2 farthest_degrees = {540.0, 91.0}, farthest_m = {1e8, 1e8};
    const glm::dvec2 farthest = is_geographic() ? farthest_degrees : farthest_m;
    const auto [low, high] = corners();
    const bool is_within = glm::all(glm::greaterThanEqual(low, -farthest)) &&
                           glm::all(glm::lessThanEqual(high, farthest));
    if (!is_within)  // which is what places that are no numbers are not, either
      fail(
          fmt::format("found a model that reaches {}, expected one within {:.10g} east and {:.10g} "
                      "north of 0, to all sides",
                      extent(), farthest.x, farthest.y));
  }

  /// Where a grid of text ends too early GDAL would look for each missing row again and again,
  /// through all that are missing before it: for hours, unless they are asked for in order.
  void require_rows_of_text() const {
    const std::string format = dataset_->GetDriverName();
    if (format != "AAIGrid" && format != "GRASSASCIIGrid" && format != "ISG") return;
    double first = 0.0;
    for (int row = 0; row < dataset_->GetRasterYSize(); ++row)
      if (dataset_->GetRasterBand(1)->RasterIO(GF_Read, 0, row, 1, 1, &first, 1, 1, GDT_Float64, 0,
                                               0, nullptr) != CE_None)
        fail(CPLGetLastErrorMsg());
  }

  std::string file_;
  GDALDatasetUniquePtr dataset_;
  std::string given_;
  OGRSpatialReference given_system_;
  std::array<double, 6> transform_ = {};
};

/// Metres on the ground about `centre`, and where that lies in them.
struct LocalSystem {
  std::string definition;  ///< PROJ's; empty: the raster's own coordinates
  glm::dvec2 centre{0.0};
};

LocalSystem local_system(const Raster& raster, const glm::dvec2& centre) {
  if (raster.system() == nullptr) return {"", centre};
  OGRSpatialReference from = *raster.system();
  OGRSpatialReference to;
  to.SetWellKnownGeogCS("WGS84");
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_degrees(
      OGRCreateCoordinateTransformation(&from, &to));
  glm::dvec2 degrees = centre;
  if (!to_degrees || to_degrees->Transform(1, &degrees.x, &degrees.y) == 0)
    raster.fail(fmt::format("[{}, {}] (terrain.centre) is no place of its coordinate system",
                            centre.x, centre.y));
  return {fmt::format("+proj=aeqd +lat_0={:.12f} +lon_0={:.12f} +datum=WGS84 +units=m", degrees.y,
                      degrees.x),
          glm::dvec2(0.0)};
}

/// Places of the raster, in cells from its upper left corner, as places of the local system and
/// back.
class Transformer {
 public:
  Transformer(const Raster& raster, const LocalSystem& local) {
    std::string target = "DST_SRS=" + local.definition;
    std::string source = "SRC_SRS=" + raster.given_system();
    std::array<char*, 3> options = {target.data(), source.data(), nullptr};
    if (raster.given_system().empty()) options[1] = nullptr;
    if (local.definition.empty()) options[0] = nullptr;
    transformer_.reset(
        GDALCreateGenImgProjTransformer2(&raster.dataset(), nullptr, options.data()));
    if (!transformer_) raster.fail(CPLGetLastErrorMsg());
  }

  void* get() const { return transformer_.get(); }

  /// The raster's cell at a place of the local system, if there is one.
  std::optional<glm::dvec2> cell_at(glm::dvec2 place) const {
    double z = 0.0;
    int success = 0;
    if (GDALGenImgProjTransform(transformer_.get(), TRUE, 1, &place.x, &place.y, &z, &success) ==
            0 ||
        success == 0 || !std::isfinite(place.x) || !std::isfinite(place.y))
      return std::nullopt;
    return place;
  }

 private:
  struct Destroy {
    void operator()(void* transformer) const { GDALDestroyGenImgProjTransformer(transformer); }
  };
  std::unique_ptr<void, Destroy> transformer_;
};

/// Side of the raster's cells in the local system.
double cell_m(const Raster& raster, const LocalSystem& local) {
  std::array<double, 6> transform = {};
  if (local.definition.empty()) {
    raster.dataset().GetGeoTransform(transform.data());
    return math::hypot(transform[1], transform[4]);
  }
  const Transformer transformer(raster, local);
  int columns = 0;
  int rows = 0;
  if (GDALSuggestedWarpOutput(&raster.dataset(), GDALGenImgProjTransform, transformer.get(),
                              transform.data(), &columns, &rows) != CE_None)
    raster.fail(CPLGetLastErrorMsg());
  return std::round(transform[1] * 0x1p20) * 0x1p-20;  // the same on every system
}

/// Cells from `first` on, up to but without `end`.
struct CellBox {
  glm::ivec2 first;
  glm::ivec2 end;
};

/// Those under the square, and a few around it; none where the square lies beyond the raster.
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

/// Refuses heights that are none. Those of all planets and moons with a known ground are in range;
/// what stands for a missing height without being declared as that is not.
void require_heights(const Raster& raster, const CellBox& box) {
  constexpr double lowest_m = -12000.0;
  constexpr double highest_m = 30000.0;
  constexpr double most_cells = 1 << 30;
  const glm::ivec2 size = glm::max(box.end - box.first, 0);
  if (1.0 * size.x * size.y > most_cells)
    raster.fail(
        fmt::format("the square (terrain.size) covers {} x {} of its cells, expected {} "
                    "at most: take a smaller square or a coarser model",
                    size.x, size.y, most_cells));
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
      const double height_m = scale.height_m(values[i]);
      if (there[i] != 0 && !(height_m >= lowest_m && height_m <= highest_m))
        raster.fail(fmt::format(
            "row {}, column {}: found {}, expected a height from {} to {} m; if it stands for a "
            "missing height, the file has to say so (gdal_edit.py -a_nodata {})",
            row + 1, box.first.x + static_cast<int>(i) + 1, values[i], lowest_m, highest_m,
            values[i]));
    }
  }
}

/// Of a box of cells, within the raster.
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
  for (std::size_t i = 0; i < there.size(); ++i)
    if (there[i] == 0) block.values[i] = std::numeric_limits<double>::quiet_NaN();
  return block;
}

/// A part of the square's samples, up to but without `end`.
struct Part {
  glm::ivec2 first;
  glm::ivec2 end;
};

/// The box of cells between half steps, and what cubic convolution needs around it.
CellBox cells_of(const CellMap& cells, const Part& part) {
  constexpr double around = 3.0;
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (int j = 2 * part.first.y; j <= 2 * part.end.y; ++j)
    for (int i = 2 * part.first.x; i <= 2 * part.end.x; ++i) {
      const glm::dvec2 cell = cells.at(i, j);
      if (std::isnan(cell.x) || std::isnan(cell.y)) continue;
      low = glm::min(low, cell);
      high = glm::max(high, cell);
    }
  constexpr double most = 1e9;
  return {glm::ivec2(glm::floor(glm::clamp(low - around, -most, most))),
          glm::ivec2(glm::ceil(glm::clamp(high + around, -most, most)))};
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

/// The stored values under the square, voids as NaN, rows southwards: a raster in memory. Part by
/// part, so that of a large raster few cells are there at a time.
GDALDatasetUniquePtr stored_square(const Raster& raster, const CellMap& cells, int samples,
                                   double cells_per_step) {
  constexpr double most_cells = 2048.0;  // along a part's side
  const int side = static_cast<int>(std::clamp(most_cells / cells_per_step, 1.0, 64.0));
  GDALDatasetUniquePtr square(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", samples, samples, 1, GDT_Float64, nullptr));
  if (!square) raster.fail(CPLGetLastErrorMsg());
  GDALRasterBand& band = *square->GetRasterBand(1);
  band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  for (int y = 0; y < samples; y += side)
    for (int x = 0; x < samples; x += side) {
      const Part part{{x, y}, glm::min(glm::ivec2(x, y) + side, samples)};
      const CellBlock block = read_cells(raster, cells_of(cells, part));
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
                                  const glm::dvec2& centre, double size_m) {
  std::vector<double> values = values_of(band);
  const std::size_t voids = count_voids(values);
  if (voids == 0) return values;
  if (2 * voids >= values.size())
    raster.fail(fmt::format(
        "{:.0f} % of the {} m (terrain.size) around [{:.10g}, {:.10g}] (terrain.centre) have no "
        "height: the model reaches {}{}",
        100.0 * static_cast<double>(voids) / static_cast<double>(values.size()), size_m, centre.x,
        centre.y, raster.extent(), raster.degrees_hint()));
  const double farthest = 2.0 * band.GetXSize();
  // Otherwise it works in files of the current folder.
  std::string in_memory = "TEMP_FILE_DRIVER=MEM";
  std::array<char*, 2> options = {in_memory.data(), nullptr};
  if (GDALFillNodata(&band, nullptr, farthest, 0, smoothing_passes, options.data(), nullptr,
                     nullptr) != CE_None)
    raster.fail(CPLGetLastErrorMsg());
  return values_of(band);
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
  const glm::dvec2 middle =
      terrain.centre.empty() ? raster.middle() : glm::dvec2(terrain.centre[0], terrain.centre[1]);
  const LocalSystem local = local_system(raster, middle);
  Elevation elevation{GroundMap<double>(samples, size_m), cell_m(raster, local)};
  require_heights(raster, cells_under(raster, local, size_m));
  const Transformer transformer(raster, local);
  const CellMap cells(
      [&](const glm::dvec2& from_middle_m) {
        return transformer.cell_at(local.centre + from_middle_m);
      },
      samples, size_m);
  const GDALDatasetUniquePtr square =
      stored_square(raster, cells, samples, elevation.heights_m.step_m() / elevation.cell_m);
  const std::vector<double> stored =
      filled_values(raster, *square->GetRasterBand(1), middle, size_m);
  const HeightScale scale = raster.height_scale();
  const auto [low, high] = std::ranges::minmax_element(stored);
  const auto [lowest_m, highest_m] = std::minmax({scale.height_m(*low), scale.height_m(*high)});
  require_slopes(raster, highest_m - lowest_m, size_m);
  auto from = stored.begin();
  for (int j = samples - 1; j >= 0; --j)  // rows run southwards
    for (int i = 0; i < samples; ++i)
      elevation.heights_m.at(i, j) = scale.height_m(*from++) - lowest_m;
  return elevation;
}

}  // namespace wold::terrain
