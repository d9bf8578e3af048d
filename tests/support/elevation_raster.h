#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>

namespace wold::test {

/// A square of land about a place of zone 11 of UTM, or so far east of it.
struct RasterOfLand {
  double size_m, cell_m;
  double east_m = 0.0;
};

/// Writes an elevation model as GeoTIFF: heights by metres east and north of that place. The file.
inline std::string write_elevation(
    const std::filesystem::path& file, const RasterOfLand& land,
    const std::function<double(double east_m, double north_m)>& height_m) {
  constexpr double place_east_m = 5e5, place_north_m = 3.8e6;
  GDALAllRegister();
  const int cells = static_cast<int>(land.size_m / land.cell_m);
  const double west_m = land.east_m - 0.5 * land.size_m, north_m = 0.5 * land.size_m;
  GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file.c_str(), cells, cells, 1, GDT_Float64, nullptr));
  std::array<double, 6> place = {place_east_m + west_m,   land.cell_m, 0.0,
                                 place_north_m + north_m, 0.0,         -land.cell_m};
  raster->SetGeoTransform(place.data());
  OGRSpatialReference system;
  system.SetFromUserInput("EPSG:32611");
  raster->SetSpatialRef(&system);
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      double value =
          height_m(west_m + (column + 0.5) * land.cell_m, north_m - (row + 0.5) * land.cell_m);
      EXPECT_EQ(raster->GetRasterBand(1)->RasterIO(GF_Write, column, row, 1, 1, &value, 1, 1,
                                                   GDT_Float64, 0, 0),
                CE_None);
    }
  return file.string();
}

}  // namespace wold::test
