#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "support/places.h"
#include "terrain/elevation.h"

/// Elevation models as people have them, in tests/data/terrain.
namespace wold::terrain {
namespace {

/// An .asc of Esri, read without GDAL.
struct AsciiGrid {
  int columns = 0, rows = 0;
  double west = 0.0, south = 0.0, cell = 0.0;
  std::vector<double> values;  ///< the northern row first

  explicit AsciiGrid(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string key;
    file >> key >> columns >> key >> rows >> key >> west >> key >> south >> key >> cell;
    if (file >> std::ws; file.peek() == 'N') file >> key >> key;
    for (double value; file >> value;) values.push_back(value);
  }

  /// Least and largest value of cells whose middles lie within a box about a place.
  std::pair<double, double> range(double x, double y, double half_x, double half_y) const {
    std::pair<double, double> range{1e9, -1e9};
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if (std::abs(west + (column + 0.5) * cell - x) > half_x) continue;
        if (std::abs(south + (rows - row - 0.5) * cell - y) > half_y) continue;
        const double value = values.at(static_cast<std::size_t>(row * columns + column));
        range = {std::min(range.first, value), std::max(range.second, value)};
      }
    return range;
  }
};

std::filesystem::path model(const char* name) {
  return wold::test::tests_folder() / "data" / "terrain" / name;
}

double rise_m(const Elevation& place) {
  const auto [low, high] = std::ranges::minmax_element(place.heights_m.values());
  return *high - *low;
}

// As OpenTopography hands it out: degrees, and nothing says so.
TEST(RealModels, FrontRangeNeedsToBeToldThatItIsInDegrees) {
  scene::Terrain terrain;
  terrain.elevation = model("front_range_srtm_gl3.asc").string();
  terrain.size_m = 6000.0;
  terrain.samples = 129;
  EXPECT_THROW(read_elevation(terrain), InputError);
  terrain.system = "EPSG:4326";
  terrain.centre = {-105.45, 40.15};
  const Elevation place = read_elevation(terrain);
  // A degree there is 85.2 km of longitude and 111.0 km of latitude.
  const AsciiGrid grid(terrain.elevation);
  const auto [low, high] =
      grid.range(terrain.centre[0], terrain.centre[1], 3.0 / 85.2, 3.0 / 111.0);
  EXPECT_GT(high - low, 300.0);
  EXPECT_NEAR(rise_m(place), high - low, 0.03 * (high - low));
  EXPECT_NEAR(place.cell_m, 81.0, 12.0);  // 71 m by 92.5 m
}

// Metres of a survey's own, with the corner at 0, 0.
TEST(RealModels, AGullyInLocalMetresKeepsItsDepth) {
  scene::Terrain terrain;
  terrain.elevation = model("bijou_grassland_5m.asc").string();
  terrain.size_m = 200.0;
  terrain.samples = 65;
  terrain.centre = {260.0, 190.0};
  const AsciiGrid grid(terrain.elevation);
  const auto [low, high] = grid.range(260.0, 190.0, 100.0, 100.0);
  EXPECT_GT(high - low, 2.0);
  const Elevation place = read_elevation(terrain);
  EXPECT_NEAR(rise_m(place), high - low, 0.05 * (high - low));
  EXPECT_NEAR(place.cell_m, 4.99, 0.01);
}

}  // namespace
}  // namespace wold::terrain
