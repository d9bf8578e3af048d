#include "terrain/elevation.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::terrain {
namespace {

constexpr double no_data = -9999.0;

/// An elevation model made for a test: value(east, north) at its cells' middles.
struct Model {
  const char* system = nullptr;  ///< "EPSG:32611"
  double west = 0.0;
  double north = 0.0;
  double cell = 1.0;
  int columns = 100;
  int rows = 100;
  std::function<double(double, double)> value;
  double scale = 1.0;
  const char* unit = "m";
};

class ElevationTest : public testing::Test {
 protected:
  std::filesystem::path write(const Model& model, const char* driver = "GTiff") {
    GDALAllRegister();
    const std::filesystem::path file = folder_.path() / "model.tif";
    GDALDatasetUniquePtr memory(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
        "", model.columns, model.rows, 1, GDT_Float64, nullptr));
    std::array<double, 6> place = {model.west, model.cell, 0.0, model.north, 0.0, -model.cell};
    memory->SetGeoTransform(place.data());
    if (model.system != nullptr) {
      OGRSpatialReference system;
      system.SetFromUserInput(model.system);
      memory->SetSpatialRef(&system);
    }
    GDALRasterBand& band = *memory->GetRasterBand(1);
    band.SetNoDataValue(no_data);
    band.SetScale(model.scale);
    band.SetUnitType(model.unit);
    for (int row = 0; row < model.rows; ++row)
      for (int column = 0; column < model.columns; ++column) {
        double value = model.value(model.west + (column + 0.5) * model.cell,
                                   model.north - (row + 0.5) * model.cell);
        EXPECT_EQ(band.RasterIO(GF_Write, column, row, 1, 1, &value, 1, 1, GDT_Float64, 0, 0),
                  CE_None);
      }
    GDALDatasetUniquePtr(GetGDALDriverManager()->GetDriverByName(driver)->CreateCopy(
        file.c_str(), memory.get(), FALSE, nullptr, nullptr, nullptr));
    return file;
  }

  wold::test::TemporaryFolder folder_{"elevation"};
};

Elevation read_elevation(const std::filesystem::path& file, const std::vector<double>& centre,
                         int samples, double size_m, const std::string& system = "") {
  return terrain::read_elevation({.elevation = file.string(),
                                  .system = system,
                                  .centre = centre,
                                  .size_m = size_m,
                                  .samples = samples});
}

/// Rise per metre to the east and to the north, between opposite ends of the middle lines.
glm::dvec2 rise(const Elevation& place) {
  const int last = place.heights_m.samples() - 1;
  return glm::dvec2(place.heights_m.at(last, last / 2) - place.heights_m.at(0, last / 2),
                    place.heights_m.at(last / 2, last) - place.heights_m.at(last / 2, 0)) /
         place.heights_m.size_m();
}

double steepest(const GroundMap<double>& heights_m) {
  double steepest = 0.0;
  for (int j = 0; j < heights_m.samples(); ++j)
    for (int i = 1; i < heights_m.samples(); ++i)
      steepest = std::max(
          steepest, std::abs(heights_m.at(i, j) - heights_m.at(i - 1, j)) / heights_m.step_m());
  return steepest;
}

// A slope in UTM zone 11 keeps its rise, but for the zone's scale (0.9996 in its middle) and the
// angle between its grid and true north, which is 0 there.
TEST_F(ElevationTest, ASlopeKeepsItsRiseAndItsDirection) {
  const auto slope = [](double east, double north) {
    return 0.2 * (east - 5e5) - 0.1 * (north - 3.8e6);
  };
  const auto file = write({"EPSG:32611", 499000.0, 3800000.0, 20.0, 100, 100, slope});
  const Elevation place = read_elevation(file, {500000.0, 3799000.0}, 101, 500.0);
  EXPECT_NEAR(place.cell_m, 20.0, 0.05);
  EXPECT_NEAR(rise(place).x, 0.2 * 0.9996, 1e-4);
  EXPECT_NEAR(rise(place).y, -0.1 * 0.9996, 1e-4);
  EXPECT_NEAR(place.heights_m.at(0, 100), 0.0, 1e-9);  // the lowest corner: north-west
}

// At 60 degrees north a degree of latitude is 111 412 m long and one of longitude 55 800 m (WGS
// 84).
TEST_F(ElevationTest, DegreesBecomeMetres) {
  const auto east = write({"EPSG:4326", 9.9, 60.1, 0.002, 100, 100,
                           [](double lon, double) { return 5580.0 * (lon - 10.0); }});
  EXPECT_NEAR(rise(read_elevation(east, {}, 65, 1000.0)).x, 0.1, 2e-4);
  const auto north = write({"EPSG:4326", 9.9, 60.1, 0.002, 100, 100,
                            [](double, double lat) { return 11141.2 * (lat - 60.0); }});
  EXPECT_NEAR(rise(read_elevation(north, {}, 65, 1000.0)).y, 0.1, 2e-4);
}

// Ten stored units a foot, a foot 0.3048 m.
TEST_F(ElevationTest, FeetAndScalesBecomeMetres) {
  const auto slope = [](double east, double) { return 10.0 * (east - 5e5); };
  const auto file = write({"EPSG:32611", 499000.0, 3800000.0, 20.0, 100, 100, slope, 0.1, "ft"});
  const Elevation place = read_elevation(file, {500000.0, 3799000.0}, 101, 500.0);
  EXPECT_NEAR(rise(place).x, 0.3048 * 0.9996, 1e-4);
}

// The first height under the square that is none, from the north-west; beyond it anything may be.
TEST_F(ElevationTest, SaysWhichHeightIsNone) {
  const auto with = [&](double wrong) {
    return write({nullptr, 0.0, 1000.0, 10.0, 100, 100, [wrong](double east, double north) {
                    const bool here =
                        east > 520.0 && east < 530.0 && north > 470.0 && north < 480.0;
                    return here ? wrong : 300.0;
                  }});
  };
  for (const double wrong : {std::numeric_limits<double>::infinity(), 30001.0, -12001.0, -32768.0})
    try {
      read_elevation(with(wrong), {}, 33, 200.0);
      FAIL() << wrong << " is no height";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("row 53, column 53: found"), std::string::npos)
          << error.what();
    }
  EXPECT_NO_THROW(read_elevation(with(-32768.0), {800.0, 200.0}, 33, 200.0));
}

TEST_F(ElevationTest, AVoidIsNoCliff) {
  const auto slope = [](double east, double north) {
    const bool hole = std::hypot(east - 450.0, north - 520.0) < 80.0;
    return hole ? no_data : 300.0 + 0.3 * east;
  };
  const Elevation place =
      read_elevation(write({"EPSG:32611", 0.0, 1000.0, 10.0, 100, 100, slope}), {}, 129, 600.0);
  for (const double height : place.heights_m.values()) EXPECT_TRUE(std::isfinite(height));
  EXPECT_LT(steepest(place.heights_m), 2.0 * 0.3);
}

// Esri's .asc has no coordinate system: it is taken as metres. A raster finer than the ground's
// samples is averaged, so that no single bump stands for many metres.
TEST_F(ElevationTest, FineRastersAreAveraged) {
  const auto chequers = [](double east, double north) {
    return (static_cast<int>(east) + static_cast<int>(north)) % 2 == 0 ? 10.0 : 20.0;
  };
  const auto file = write({nullptr, 0.0, 200.0, 1.0, 200, 200, chequers}, "AAIGrid");
  const Elevation place = read_elevation(file, {}, 17, 160.0);
  EXPECT_NEAR(place.cell_m, 1.0, 1e-9);
  for (const double height : place.heights_m.values()) EXPECT_LT(height, 1.0);
}

// Found by fuzzing: it took hours.
TEST_F(ElevationTest, AGridOfTextThatEndsTooEarlyIsRefusedAtOnce) {
  const std::filesystem::path file = folder_.path() / "short.asc";
  write_file(file, "ncols 2\nnrows 5000\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n");
  try {
    read_elevation(file, {}, 9, 60.0);
    FAIL() << "half of it is missing";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("File short"), std::string::npos) << error.what();
  }
}

TEST_F(ElevationTest, SaysWhereTheModelIsWhenTheSceneLiesBeside) {
  const auto file =
      write({"EPSG:4326", 9.9, 60.1, 0.002, 100, 100, [](double, double) { return 1.0; }});
  try {
    read_elevation(file, {12.0, 60.0}, 33, 100.0);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("from 9.9 to 10.1 degrees east and from 59.9 to 60.1"),
              std::string::npos)
        << error.what();
  }
  const std::filesystem::path text = folder_.path() / "text.tif";
  FILE* out = std::fopen(text.c_str(), "w");
  std::fputs("no raster", out);
  std::fclose(out);
  EXPECT_THROW(read_elevation(text, {}, 33, 100.0), InputError);
}

/// What is said of a model that cannot be read.
std::string fault_of(const std::function<void()>& reading) {
  try {
    reading();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A common .asc: degrees, and nothing says so.
TEST_F(ElevationTest, DegreesThatNobodyNamesAreNotTakenForMetres) {
  const auto file = write({nullptr, 9.9, 60.1, 0.002, 100, 100,
                           [](double lon, double) { return 5580.0 * (lon - 10.0); }},
                          "AAIGrid");
  const char* hint = "looks like degrees: set terrain.system = \"EPSG:4326\"";
  EXPECT_NE(fault_of([&] { read_elevation(file, {}, 33, 1000.0); }).find(hint), std::string::npos);
  // A square that the model covers, were it metres, would be a wall.
  EXPECT_NE(fault_of([&] { read_elevation(file, {}, 33, 0.1); }).find(hint), std::string::npos);
  const Elevation place = read_elevation(file, {}, 65, 1000.0, "EPSG:4326");
  EXPECT_NEAR(rise(place).x, 0.1, 2e-4);
  EXPECT_NEAR(place.cell_m, std::hypot(222.8, 111.6) / std::sqrt(2.0), 1.0);  // as long across
  const auto metres = write({nullptr, 0.0, 40.0, 1.0, 40, 40, [](double, double) { return 7.0; }});
  EXPECT_EQ(fault_of([&] {
              read_elevation(metres, {90.0, 9.0}, 33, 10.0);
            }).find("degrees"),
            std::string::npos);
}

// PROJ 9.1 would crash. Past the date line and around the globe is near enough.
TEST_F(ElevationTest, ModelsOutsideOfTheWorldAreRefused) {
  const auto flat = [](double, double) { return 1.0; };
  for (const auto& [system, west, north] :
       {std::tuple("EPSG:32611", 1.1e8, 3.8e6), std::tuple("EPSG:32611", 5e5, -1e30),
        std::tuple("EPSG:4326", 541.0, 0.0), std::tuple("EPSG:4326", 0.0, 92.0)}) {
    const auto file = write({system, west, north, 0.002, 40, 40, flat});
    EXPECT_NE(fault_of([&] {
                read_elevation(file, {}, 33, 100.0);
              }).find("found a model that reaches from "),
              std::string::npos)
        << west << " " << north;
  }
  const auto beyond = write({"EPSG:4326", 359.95, 60.0, 0.002, 40, 40, flat});
  EXPECT_EQ(fault_of([&] { read_elevation(beyond, {}, 33, 100.0); }), "");
}

// What the scene says wins: the slope of UTM zone 11, stored as that of another zone.
TEST_F(ElevationTest, TheSystemThatIsGivenWins) {
  const auto slope = [](double east, double) { return 0.2 * (east - 5e5); };
  const auto file = write({"EPSG:4326", 499000.0, 3800000.0, 20.0, 100, 100, slope});
  const Elevation place = read_elevation(file, {500000.0, 3799000.0}, 101, 500.0, "EPSG:32611");
  EXPECT_NEAR(rise(place).x, 0.2 * 0.9996, 1e-4);
  for (const char* unknown : {"EPSG:1", "EPSG:999999", "EPSG:5773"})  // the last one is heights
    EXPECT_EQ(fault_of([&] {
                read_elevation(file, {}, 33, 500.0, unknown);
              }).find("terrain.system: found EPSG:"),
              0u)
        << unknown;
}

}  // namespace
}  // namespace wold::terrain
