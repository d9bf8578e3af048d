#include "terrain/photo.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/error.h"
#include "core/random.h"
#include "support/elevation_raster.h"
#include "support/temporary_folder.h"
#include "terrain/ground.h"
#include "terrain/relief.h"

namespace wold::terrain {
namespace {

constexpr double square_m = 1000.0;

using Colour = std::function<glm::dvec3(double east_m, double north_m)>;

double hills_m(double east_m, double north_m) {
  return 25.0 * std::sin(0.02 * east_m) * std::cos(0.017 * north_m) + 0.05 * north_m;
}

class PhotoTest : public testing::Test {
 protected:
  /// A square of 1 km of hills.
  scene::Terrain place() {
    scene::Terrain terrain;
    terrain.elevation = test::write_elevation(folder_.path() / "dem.tif", {2000.0, 20.0}, hills_m);
    terrain.size_m = square_m;
    terrain.samples = 101;
    terrain.relief_m = 0.0;
    return terrain;
  }

  /// A photo about the square's middle, of albedos by place from it.
  std::string photo(double size_m, double cell_m, const Colour& albedo, int bands = 3,
                    GDALDataType type = GDT_Byte) {
    GDALAllRegister();
    const std::filesystem::path file = folder_.path() / "photo.tif";
    const int cells = static_cast<int>(size_m / cell_m);
    GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), cells, cells, bands, type, nullptr));
    std::array<double, 6> place = {5e5 - 0.5 * size_m,   cell_m, 0.0,
                                   3.8e6 + 0.5 * size_m, 0.0,    -cell_m};
    raster->SetGeoTransform(place.data());
    OGRSpatialReference system;
    system.SetFromUserInput("EPSG:32611");
    raster->SetSpatialRef(&system);
    std::vector<std::uint8_t> values(static_cast<std::size_t>(cells) * 3);
    for (int row = 0; row < cells; ++row) {
      for (int column = 0; column < cells; ++column) {
        const glm::dvec3 display = srgb_encoded(
            albedo((column + 0.5) * cell_m - 0.5 * size_m, 0.5 * size_m - (row + 0.5) * cell_m));
        for (int band = 0; band < 3; ++band)
          values[static_cast<std::size_t>(band * cells + column)] =
              static_cast<std::uint8_t>(std::lround(255.0 * display[band]));
      }
      EXPECT_EQ(raster->RasterIO(GF_Write, 0, row, cells, 1, values.data(), cells, 1, GDT_Byte,
                                 bands, nullptr, 1, cells, cells, nullptr),
                CE_None);
    }
    return file.string();
  }

  static std::string refusal(const scene::Terrain& terrain) {
    try {
      read_photo(terrain, make_ground(terrain, 3).heights_m);
    } catch (const InputError& error) {
      return error.what();
    }
    return "taken";
  }

  wold::test::TemporaryFolder folder_{"photo"};
};

constexpr glm::dvec3 meadow(0.10, 0.16, 0.045), sand(0.32, 0.27, 0.19), woods(0.02, 0.031, 0.014);

TEST_F(PhotoTest, SaysWhereGrassGrowsAndWhatColourOtherGroundHas) {
  scene::Terrain terrain = place();
  terrain.photo = photo(1400.0, 10.0, [](double east_m, double north_m) {
    return east_m < 0.0 ? meadow : north_m < 0.0 ? sand : woods;
  });
  const auto seen = read_photo(terrain, Heightfield(17, square_m));
  ASSERT_TRUE(seen);
  EXPECT_GT(seen->at({200.0, 700.0}).grass, 0.95);
  const LandCover::Shares bare = seen->at({800.0, 200.0}), dark = seen->at({800.0, 800.0});
  EXPECT_LT(bare.grass, 0.05);
  EXPECT_LT(dark.grass, 0.1);
  EXPECT_EQ(bare.coloured, 1.0);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(bare.albedo[c], sand[c], 0.01);
    EXPECT_NEAR(dark.albedo[c], woods[c], 0.004);
  }
}

// Light by Lambert's law on hills of one albedo, and of two that do not follow the slopes.
TEST_F(PhotoTest, ShadingIsTakenOut) {
  const scene::Terrain terrain = place();
  const Heightfield heights_m = make_ground(terrain, 3).heights_m;
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.6, -0.3, 0.8));
  const auto light = [&](const glm::dvec2& at_m) {
    const glm::dvec3 up = normal(heights_m, at_m.x, at_m.y);
    return (0.3 + std::max(0.0, glm::dot(up, sun))) / (0.3 + sun.z);
  };
  PhotoMap shaded(201, square_m), albedo(201, square_m);
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 201; ++i) {
      const bool pale = random_uniform({3, 0, static_cast<std::uint64_t>(j * 201 + i), 0}) < 0.4;
      albedo.at(i, j) = pale ? glm::dvec3(0.2) : glm::dvec3(0.1, 0.12, 0.05);
      shaded.at(i, j) = albedo.at(i, j) * light(albedo.place_m(i, j));
    }
  const PhotoMap even = without_shading(shaded, heights_m);
  double off = 0.0, off_before = 0.0, mean = 0.0, mean_before = 0.0;
  for (std::size_t k = 0; k < even.values().size(); ++k) {
    off += std::abs(even.values()[k].g / albedo.values()[k].g - 1.0) / 40401.0;
    off_before += std::abs(shaded.values()[k].g / albedo.values()[k].g - 1.0) / 40401.0;
    mean += luminance(even.values()[k]) / 40401.0;
    mean_before += luminance(shaded.values()[k]) / 40401.0;
  }
  EXPECT_GT(off_before, 0.1);
  EXPECT_LT(off, 0.25 * off_before);
  EXPECT_NEAR(mean, mean_before, 1e-9);
}

TEST_F(PhotoTest, OfLevelGroundStaysAsItIs) {
  PhotoMap photo(33, square_m, glm::dvec3(0.1));
  photo.at(3, 4) = glm::dvec3(0.7, 0.2, 0.1);
  const PhotoMap even = without_shading(photo, Heightfield(17, square_m));
  EXPECT_NEAR(even.at(3, 4).r, 0.7, 1e-9);
  EXPECT_NEAR(even.at(9, 9).g, 0.1, 1e-9);
}

// Half of the cells of a fine photo are not left out: they are averaged, as light is.
TEST_F(PhotoTest, FineCellsAreAveraged) {
  scene::Terrain terrain = place();
  terrain.size_m = 20.0;
  terrain.samples = 17;
  int column = 0;
  terrain.photo = photo(20.9, 0.0095,
                        [&](double, double) { return glm::dvec3(column++ % 2 == 0 ? 0.0 : 0.5); });
  const auto seen = read_photo(terrain, Heightfield(17, 20.0));
  for (const double at_m : {3.0, 10.0, 17.0})
    EXPECT_NEAR(seen->at({at_m, at_m}).albedo.g, 0.25, 0.005);
}

TEST_F(PhotoTest, SaysNothingBeyondItsBorder) {
  scene::Terrain terrain = place();
  terrain.photo = photo(400.0, 10.0, [](double, double) { return sand; });
  const auto seen = read_photo(terrain, Heightfield(17, square_m));
  EXPECT_EQ(seen->at({100.0, 100.0}).coloured, 0.0);
  EXPECT_EQ(seen->at({100.0, 100.0}).grass, 1.0);
  EXPECT_EQ(seen->at({500.0, 500.0}).coloured, 1.0);
}

TEST_F(PhotoTest, WhatIsNoPhotoIsRefused) {
  const auto grey = [](double, double) { return glm::dvec3(0.2); };
  scene::Terrain terrain = place();
  terrain.photo = photo(1400.0, 20.0, grey, 1);
  EXPECT_NE(refusal(terrain).find("found 1 bands, expected three or more"), std::string::npos)
      << refusal(terrain);
  terrain.photo = photo(1400.0, 20.0, grey, 3, GDT_UInt16);
  EXPECT_NE(refusal(terrain).find("UInt16, expected bytes"), std::string::npos);
  terrain.photo = photo(1400.0, 20.0, grey);
  terrain.centre = {5e5 + 900.0, 3.8e6};
  terrain.size_m = 150.0;
  EXPECT_NE(refusal(terrain).find("shows nothing of the square"), std::string::npos);
}

}  // namespace
}  // namespace wold::terrain
