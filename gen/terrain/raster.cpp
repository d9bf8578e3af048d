#include "terrain/raster.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/elementary.h"
#include "core/error.h"
#include "core/files.h"
#include "core/quiet_gdal.h"

namespace wold::terrain {
namespace {

/// By the absolute path, which GDAL cannot take for anything but a file's.
GDALDatasetUniquePtr open(const std::filesystem::path& file) {
  require_regular_file(file);
  return GDALDatasetUniquePtr(GDALDataset::Open(std::filesystem::absolute(file).c_str(),
                                                GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
}

const char* expected(std::string_view key) {
  if (key == "terrain.cover") return "a raster of land cover";
  return key == "terrain.photo" ? "an orthophoto" : "an elevation model";
}

}  // namespace

Raster::Raster(const std::filesystem::path& file, const std::string& system, const char* key)
    : file_(file.string()), key_(key), dataset_(open(file)), given_(system) {
  if (!dataset_)
    fail(fmt::format("expected {} of one of these kinds: {}: {}", expected(key),
                     fmt::join(elevation_drivers, ", "), CPLGetLastErrorMsg()));
  if (dataset_->GetRasterCount() == 0) fail("it has no band of numbers");
  if (dataset_->GetGeoTransform(transform_.data()) != CE_None)
    fail("it does not say where on the ground it lies (no geotransform)");
  require_place();
  require_rows_of_text();
  if (!given_.empty()) take_system();
  require_extent();
}

void Raster::fail(const std::string& reason) const {
  throw InputError(fmt::format("{}: {}: {}", key_, file_, reason));
}

const OGRSpatialReference* Raster::system() const {
  return given_.empty() ? dataset_->GetSpatialRef() : &given_system_;
}

glm::dvec2 Raster::place(double column, double row) const {
  const auto& t = transform_;
  return {t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]};
}

glm::dvec2 Raster::middle() const {
  return place(dataset_->GetRasterXSize() / 2.0, dataset_->GetRasterYSize() / 2.0);
}

Raster::Corners Raster::corners() const {
  const double columns = dataset_->GetRasterXSize();
  const double rows = dataset_->GetRasterYSize();
  Corners box{place(0, 0), place(0, 0)};
  for (const glm::dvec2& corner : {place(columns, 0), place(0, rows), place(columns, rows)})
    box = {glm::min(box.low, corner), glm::max(box.high, corner)};
  return box;
}

std::string Raster::extent() const {
  const auto [low, high] = corners();
  const char* unit = is_geographic() ? " degrees" : "";
  return fmt::format("from {:.10g} to {:.10g}{} east and from {:.10g} to {:.10g}{} north", low.x,
                     high.x, unit, low.y, high.y, unit);
}

HeightScale Raster::height_scale() const {
  GDALRasterBand& band = *dataset_->GetRasterBand(1);
  const std::string unit = band.GetUnitType();
  const bool feet = unit == "ft" || unit == "feet" || unit == "foot" || unit == "us-ft" ||
                    unit == "US survey foot";
  const double unit_m = feet ? 0.3048 : 1.0;
  return {band.GetScale() * unit_m, band.GetOffset() * unit_m};
}

bool Raster::looks_like_degrees() const {
  constexpr double coarsest_cell = 0.1;  // 11 km; grids of metres are coarser than a decimetre
  if (system() != nullptr) return false;
  const auto [low, high] = corners();
  const auto& t = transform_;
  return low.x >= -180.0 && high.x <= 360.0 && low.y >= -90.0 && high.y <= 90.0 &&
         std::max(math::hypot(t[1], t[4]), math::hypot(t[2], t[5])) < coarsest_cell;
}

std::string Raster::degrees_hint() const {
  if (!looks_like_degrees()) return "";
  return "; the file does not say its coordinate system and is taken for metres, but looks like "
         "degrees: set terrain.system = \"EPSG:4326\"";
}

void Raster::take_system() {
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

void Raster::require_place() const {
  const auto& t = transform_;
  const bool finite = std::all_of(t.begin(), t.end(), [](double x) { return std::isfinite(x); });
  if (!finite || t[1] * t[5] - t[2] * t[4] == 0.0)
    fail(fmt::format("found cells of {} x {} at [{}, {}], expected a place and a size", t[1], t[5],
                     t[0], t[3]));
  const HeightScale scale = height_scale();
  if (!std::isfinite(scale.factor) || scale.factor == 0.0 || !std::isfinite(scale.offset_m))
    fail(fmt::format("found heights scaled by {} and moved by {} m, expected finite numbers",
                     scale.factor, scale.offset_m));
}

/// PROJ 9.1 crashes where it is asked about places far outside of the world.
void Raster::require_extent() const {
  constexpr glm::dvec2 farthest_degrees = {540.0, 91.0}, farthest_m = {1e8, 1e8};
  const glm::dvec2 farthest = is_geographic() ? farthest_degrees : farthest_m;
  const auto [low, high] = corners();
  const bool is_within = glm::all(glm::greaterThanEqual(low, -farthest)) &&
                         glm::all(glm::lessThanEqual(high, farthest));
  if (!is_within)  // which is what places that are no numbers are not, either
    fail(fmt::format(
        "found a model that reaches {}, expected one within {:.10g} east and {:.10g} north of 0, "
        "to all sides",
        extent(), farthest.x, farthest.y));
}

/// Where a grid of text ends too early GDAL would look for each missing row again and again,
/// through all that are missing before it: for hours, unless they are asked for in order.
void Raster::require_rows_of_text() const {
  const std::string format = dataset_->GetDriverName();
  if (format != "AAIGrid" && format != "GRASSASCIIGrid" && format != "ISG") return;
  double first = 0.0;
  for (int row = 0; row < dataset_->GetRasterYSize(); ++row)
    if (dataset_->GetRasterBand(1)->RasterIO(GF_Read, 0, row, 1, 1, &first, 1, 1, GDT_Float64, 0, 0,
                                             nullptr) != CE_None)
      fail(CPLGetLastErrorMsg());
}

}  // namespace wold::terrain
