#include "maps/maps.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "core/error.h"
#include "maps/geotiff.h"
#include "support/places.h"
#include "support/temporary_folder.h"

namespace wold::maps {
namespace {

namespace fs = std::filesystem;

/// A GeoTIFF as any other program reads it.
class ReadMap {
 public:
  explicit ReadMap(const fs::path& file) {
    GDALAllRegister();
    raster_.reset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
    EXPECT_TRUE(raster_) << file;
    raster_->GetGeoTransform(place_.data());
  }

  GDALDataset& raster() { return *raster_; }
  const std::array<double, 6>& place() const { return place_; }
  std::string unit() const { return raster_->GetRasterBand(1)->GetUnitType(); }

  /// The value of the pixel at a place in the file's own coordinates.
  double at(const glm::dvec2& place) const {
    float value = 0.0F;
    const int x = static_cast<int>(std::floor((place.x - place_[0]) / place_[1]));
    const int y = static_cast<int>(std::floor((place.y - place_[3]) / place_[5]));
    EXPECT_EQ(
        raster_->GetRasterBand(1)->RasterIO(GF_Read, x, y, 1, 1, &value, 1, 1, GDT_Float32, 0, 0),
        CE_None);
    return double{value};
  }

  /// The same at a longitude and latitude.
  double at_degrees(const glm::dvec2& degrees) const {
    OGRSpatialReference world;
    world.SetWellKnownGeogCS("WGS84");
    world.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> to_map(
        OGRCreateCoordinateTransformation(&world, raster_->GetSpatialRef()));
    EXPECT_TRUE(to_map);
    glm::dvec2 place = degrees;
    EXPECT_TRUE(to_map && to_map->Transform(1, &place.x, &place.y) != 0);
    return at(place);
  }

 private:
  GDALDatasetUniquePtr raster_;
  std::array<double, 6> place_ = {};
};

class Maps : public testing::Test {
 protected:
  std::vector<MapFile> written(const scene::Scene& scene, const std::vector<int>& frames,
                               const std::string& source = "one") {
    SilentProgress progress;
    return write_maps(scene, nullptr, frames, folder_.path() / "maps", folder_.path() / "snow",
                      source, progress);
  }
  ReadMap map(const char* name) const { return ReadMap(folder_.path() / "maps" / name); }

  wold::test::TemporaryFolder folder_{"maps"};
};

scene::Scene front_range() {
  scene::Scene scene;
  scene.terrain.elevation =
      (wold::test::tests_folder() / "data" / "terrain" / "front_range_srtm_gl3.asc").string();
  scene.terrain.system = "EPSG:4326";
  scene.terrain.centre = {-105.522, 40.118};
  scene.terrain.size_m = 3000.0;
  scene.terrain.samples = 101;
  scene.ageing.frames = {0.2, 0.6};
  scene.render.size_px = {160, 90};
  return scene;
}

// Beaver Reservoir lies where it lies in the world, as high as the model has it, level, and without
// grass; and the cell of the model's row 82, column 44 from the north-west is where it was.
TEST_F(Maps, LieWhereTheModelLies) {
  written(front_range(), {2});
  const glm::dvec2 lake(-105.5246, 40.1175);
  EXPECT_NEAR(map("height.tif").at_degrees(lake), 2791.0, 0.01);
  EXPECT_NEAR(map("slope.tif").at_degrees(lake), 0.0, 0.01);
  EXPECT_NEAR(map("growth.tif").at_degrees(lake), 0.0, 1e-6);
  EXPECT_NEAR(map("water.tif").at_degrees(lake), 1.0, 1e-6);
  EXPECT_EQ(map("height.tif").unit(), "m");
  const ReadMap height = map("height.tif");
  EXPECT_NEAR(height.place()[1], 30.0, 1e-9);
  EXPECT_NEAR(height.place()[5], -30.0, 1e-9);
  EXPECT_NEAR(height.place()[0], -1515.0, 1e-9);
  EXPECT_NEAR(height.place()[3], 1515.0, 1e-9);
}

TEST_F(Maps, AreThoseOfTheFramesThatAreAskedFor) {
  const std::vector<MapFile> files = written(front_range(), {2});
  EXPECT_EQ(files.back().name, "weathering");
  EXPECT_EQ(files.back().frame, 2);
  EXPECT_FALSE(fs::exists(folder_.path() / "maps" / "weathering_0001.tif"));
  for (const MapFile& map : files) EXPECT_TRUE(fs::exists(map.file)) << map.file;
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder_.path() / "maps"))
    count += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(count, files.size());  // nothing else, nothing half-written
  const std::vector<fs::path> expected = map_files(folder_.path() / "maps", {2});
  for (const MapFile& map : files) EXPECT_EQ(std::ranges::count(expected, map.file), 1) << map.file;
}

// Snow of 20 mm of water that has fallen and not melted weighs that, and is some ten times as deep.
TEST_F(Maps, HaveSnowAsDeepAsItsWaterSays) {
  scene::Scene scene;
  scene.terrain.samples = 65;
  scene.weather.temperature_c = -8.0;
  scene.weather.precipitation_mm_h = 2.0;
  scene.weather.earlier_h = 10.0;
  scene.ageing.frames = {0.5};
  written(scene, {1});
  const ReadMap water = map("snow_water_0001.tif"), depth = map("snow_depth_0001.tif");
  double water_mm = 0.0, depth_m = 0.0;
  int places = 0;
  for (double y = 2.0; y < 40.0; y += 1.0)
    for (double x = 2.0; x < 40.0; x += 1.0, ++places) {
      water_mm += water.at({x, y});
      depth_m += depth.at({x, y});
    }
  EXPECT_NEAR(water_mm / places, 20.0, 1.0);
  EXPECT_GT(depth_m / places, 0.08);
  EXPECT_LT(depth_m / places, 0.5);
  EXPECT_EQ(water.unit(), "mm");
}

// North is up: what is higher in the north is in the picture's first rows.
TEST_F(Maps, HaveTheNorthAbove) {
  scene::Scene scene;
  scene.terrain.samples = 65;
  scene.terrain.relief_m = 0.0;
  written(scene, {});
  ReadMap height = map("height.tif");
  EXPECT_GT(height.at({20.0, 40.0}), height.at({20.0, 2.0}) + 2.0);
  EXPECT_EQ(height.raster().GetSpatialRef(), nullptr);
}

// A run that goes on writes what is missing, and what another source or another program made.
TEST_F(Maps, ThatAreThereFromTheSameSourceStay) {
  const scene::Scene scene;
  const fs::path maps = folder_.path() / "maps";
  const auto time_of = [&](const char* name) { return fs::last_write_time(maps / name); };
  const fs::file_time_type long_ago{};
  const std::vector<MapFile> files = written(scene, {1, 2});
  for (const MapFile& map : files) fs::last_write_time(map.file, long_ago);
  fs::remove(maps / "weathering_0002.tif");
  std::ofstream(maps / "slope.tif") << "somebody's notes";
  const std::vector<MapFile> again = written(scene, {1, 2});
  EXPECT_EQ(again.size(), files.size());
  EXPECT_EQ(time_of("height.tif"), long_ago);
  EXPECT_EQ(time_of("weathering_0001.tif"), long_ago);
  EXPECT_EQ(map("slope.tif").unit(), "deg");
  EXPECT_TRUE(fs::exists(maps / "weathering_0002.tif"));
  for (const MapFile& map : files) fs::last_write_time(map.file, long_ago);
  scene::Scene higher = scene;
  higher.terrain.relief_m *= 2.0;  // as if its model had been changed
  written(higher, {1});
  EXPECT_NE(time_of("height.tif"), long_ago);
  for (const MapFile& map : files) fs::last_write_time(map.file, long_ago);
  written(scene, {1}, "another");
  EXPECT_NE(time_of("height.tif"), long_ago);
  EXPECT_NE(time_of("weathering_0001.tif"), long_ago);
}

TEST_F(Maps, AreNotWrittenIntoAFolderThatIsAFile) {
  const fs::path file = folder_.path() / "no_folder.tif";
  EXPECT_THROW(write_geotiff(file / "height.tif", FactorMap(5, 10.0), {}, {"height", "m"}, ""),
               FileError);
}

}  // namespace
}  // namespace wold::maps
