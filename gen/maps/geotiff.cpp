#include "maps/geotiff.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "core/quiet_gdal.h"
#include "core/temporary_name.h"
#include "terrain/local_system.h"

namespace wold::maps {
namespace {

namespace fs = std::filesystem;

/// The metadata item of what a map was made from.
constexpr const char* source_item = "WOLD_SOURCE";

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
  throw FileError(fmt::format("{}: {}", file.string(), reason));
}

GDALDatasetUniquePtr created(const fs::path& file, int side) {
  std::array<std::string, 3> words = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES"};
  std::array<char*, 4> options = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALDatasetUniquePtr raster(
      driver->Create(file.c_str(), side, side, 1, GDT_Float32, options.data()));
  if (!raster) fail(file, CPLGetLastErrorMsg());
  return raster;
}

void put_in_place(GDALDataset& raster, const FactorMap& map, const Georeference& place) {
  const double step_m = map.step_m();
  const double north_m = place.south_west_m.y + map.size_m();
  std::array<double, 6> transform = {
      place.south_west_m.x - 0.5 * step_m, step_m, 0.0, north_m + 0.5 * step_m, 0.0, -step_m};
  raster.SetGeoTransform(transform.data());
  if (place.system.empty()) return;
  OGRSpatialReference system;
  system.SetFromUserInput(place.system.c_str());
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  raster.SetSpatialRef(&system);
}

void write_rows(const fs::path& file, GDALRasterBand& band, const FactorMap& map) {
  const int side = map.samples();
  std::vector<float> row(static_cast<std::size_t>(side));
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) row[static_cast<std::size_t>(i)] = map.at(i, side - 1 - j);
    if (band.RasterIO(GF_Write, 0, j, side, 1, row.data(), side, 1, GDT_Float32, 0, 0, nullptr) !=
        CE_None)
      fail(file, CPLGetLastErrorMsg());
  }
}

}  // namespace

Georeference georeference(const std::string& elevation, const std::string& system,
                          const std::vector<double>& centre, double size_m) {
  if (elevation.empty()) return {};
  const QuietGdal quiet;
  const terrain::Raster raster(elevation, system);
  const terrain::LocalSystem local = terrain::local_system(
      raster, centre.empty() ? raster.middle() : glm::dvec2(centre[0], centre[1]));
  return {local.definition, local.centre - 0.5 * size_m};
}

void write_geotiff(const fs::path& file, const FactorMap& map, const Georeference& place,
                   const Quantity& quantity, const std::string& source) {
  const QuietGdal quiet;
  const fs::path part = temporary_name(file);
  {
    const GDALDatasetUniquePtr raster = created(part, map.samples());
    put_in_place(*raster, map, place);
    raster->SetMetadataItem(source_item, source.c_str());
    GDALRasterBand& band = *raster->GetRasterBand(1);
    band.SetDescription(quantity.name);
    if (*quantity.unit != '\0') band.SetUnitType(quantity.unit);
    write_rows(file, band, map);
    CPLErrorReset();
    raster->FlushCache();
    if (CPLGetLastErrorType() >= CE_Failure) {
      const std::string reason = CPLGetLastErrorMsg();
      std::error_code ignored;
      fs::remove(part, ignored);
      fail(file, reason);
    }
  }
  std::error_code error;
  fs::rename(part, file, error);
  if (error) fail(file, error.message());
}

std::string source_of_geotiff(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {};
  const QuietGdal quiet;
  constexpr std::array<const char*, 2> drivers = {"GTiff", nullptr};
  const GDALDatasetUniquePtr raster(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data()));
  const char* source = raster ? raster->GetMetadataItem(source_item) : nullptr;
  return source == nullptr ? "" : source;
}

}  // namespace wold::maps
