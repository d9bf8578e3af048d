#include "terrain/land_cover.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "core/error.h"
#include "scene/cover_classes.h"
#include "support/temporary_folder.h"
#include "terrain/ground.h"

namespace wold::terrain {
namespace {

constexpr double size_m = 1000.0;

/// Two classes: what grows in the west, and what is a dark colour in the east; water in a square.
const std::vector<scene::CoverClass> classes = {
    {1, 0.8, 0.0, {}}, {2, 0.0, 0.0, {0.1, 0.2, 0.3}}, {3, 0.0, 1.0, {}}};

LandCover halves() {
  GroundMap<int> number(101, size_m, 0);
  for (int j = 0; j < 101; ++j)
    for (int i = 51; i < 101; ++i) number.at(i, j) = 1;
  return {std::move(number), classes, 4};
}

TEST(LandCover, SaysWhatItsClassesSay) {
  const LandCover cover = halves();
  const LandCover::Shares west = cover.at({200.0, 500.0}), east = cover.at({800.0, 500.0});
  EXPECT_DOUBLE_EQ(west.grass, 0.8);
  EXPECT_DOUBLE_EQ(west.coloured, 0.0);
  EXPECT_DOUBLE_EQ(east.grass, 0.0);
  EXPECT_DOUBLE_EQ(east.coloured, 1.0);
  EXPECT_NEAR(east.albedo.y, 0.2F, 1e-6);
}

// The border runs at 505 m, half-way between the classes' steps, on average, not straight, and is
// one step wide where one crosses it.
TEST(LandCover, HasARaggedBorder) {
  const LandCover cover = halves();
  double mean_m = 0.0, square_m2 = 0.0;
  constexpr int rows = 900;
  for (int row = 0; row < rows; ++row) {
    double east_m = 400.0;
    while (cover.at({east_m, 50.0 + row}).coloured < 0.5) east_m += 0.25;
    mean_m += east_m / rows;
    square_m2 += east_m * east_m / rows;
  }
  EXPECT_NEAR(mean_m, 505.0, 2.5);
  const double deviation_m = std::sqrt(square_m2 - mean_m * mean_m);
  EXPECT_GT(deviation_m, 1.0);
  EXPECT_LT(deviation_m, 10.0);
}

TEST(LandCover, KnowsNothingWhereItHasNone) {
  const LandCover cover(GroundMap<int>(11, size_m, -1), classes, 4);
  EXPECT_DOUBLE_EQ(cover.at({300.0, 300.0}).grass, 1.0);
  EXPECT_DOUBLE_EQ(cover.at({300.0, 300.0}).coloured, 0.0);
}

/// A square of water, 300 m wide, in the middle.
LandCover lake() {
  GroundMap<int> number(101, size_m, 0);
  for (int j = 35; j <= 65; ++j)
    for (int i = 35; i <= 65; ++i) number.at(i, j) = 2;
  return {std::move(number), classes, 4};
}

Heightfield falling(double slope) {
  Heightfield heights_m(101, size_m);
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 101; ++i) heights_m.at(i, j) = static_cast<float>(100.0 + slope * 10.0 * i);
  return heights_m;
}

TEST(LandCover, HasALakeWhereItsWaterIsLevel) {
  const auto lakes = with_covered_water(std::nullopt, lake(), falling(0.002));
  ASSERT_TRUE(lakes);
  ASSERT_EQ(lakes->levels_m.size(), 1U);
  EXPECT_NEAR(lakes->levels_m[0], 101.0, 0.1);
  EXPECT_EQ(lakes->number.at(50, 50), 0);
  EXPECT_EQ(lakes->number.at(20, 50), -1);
}

// A river crosses the ground from south to north, two cells to the east and one to the north at a
// time, and falls to the west by 2 %.
LandCover brook() {
  GroundMap<int> number(101, size_m, 0);
  for (int k = 0; k <= 50; ++k) {
    number.at(2 * k, 25 + k) = 2;
    if (k < 50) number.at(2 * k + 1, 25 + k) = 2;
  }
  return {std::move(number), classes, 4};
}

TEST(LandCover, ItsRiversFallWithTheGround) {
  const auto rivers = with_covered_water(std::nullopt, brook(), falling(0.02));
  ASSERT_TRUE(rivers);
  const Water water(*rivers, 1);
  for (const double east_m : {105.0, 355.0, 605.0, 855.0}) {
    const glm::dvec2 at_m(east_m, 250.0 + 0.5 * east_m);
    EXPECT_NEAR(water.level_m(at_m), 100.0 + 0.02 * east_m, 0.8) << east_m;
    EXPECT_NEAR(water.level_m(at_m), water.level_m(at_m + glm::dvec2(-5.0, 10.0)), 0.25) << east_m;
  }
  EXPECT_LT(water.level_m({301.0, 401.0}), water.level_m({304.0, 403.0}));  // no steps
}

/// Of water along the diagonal from the south-west, across it, as pieces of that size show it.
double width_of_diagonal_m(const Water& water, double along_m, double piece_m) {
  constexpr int pieces = 40;  // to either side
  double width_m = 0.0;
  for (int k = -pieces; k <= pieces; ++k) {
    const double aside_m = piece_m * k;
    width_m +=
        piece_m * std::sqrt(2.0) * water.share({along_m + aside_m, along_m - aside_m}, piece_m);
  }
  return width_m;
}

// A cell's width is less than Water shows, and here cells meet at their corners alone.
TEST(LandCover, ItsRiversAreSeenHoweverNarrow) {
  GroundMap<int> number(101, size_m, 0);
  for (int k = 0; k <= 100; ++k) number.at(k, k) = 2;
  const auto rivers =
      with_covered_water(std::nullopt, LandCover(std::move(number), classes, 4), falling(0.02));
  ASSERT_TRUE(rivers);
  const Water water(*rivers, 1);
  for (double along_m = 30.0; along_m < 970.0; along_m += 2.5) {
    const double width_m = width_of_diagonal_m(water, along_m, 0.5);
    EXPECT_GT(width_m, 4.0) << along_m;
    EXPECT_LT(width_m, 20.0) << along_m;
  }
}

// A lake in the west, which a river joins that comes down 20 m from the east.
TEST(LandCover, ItsRiversComeDownToItsLakes) {
  GroundMap<int> number(101, size_m, 0);
  for (int j = 20; j <= 80; ++j)
    for (int i = 5; i <= 60; ++i) number.at(i, j) = 2;
  for (int i = 61; i <= 100; ++i)
    for (int j = 49; j <= 51; ++j) number.at(i, j) = 2;
  Heightfield heights_m(101, size_m, 100.0F);
  for (int j = 0; j < 101; ++j)
    for (int i = 61; i < 101; ++i) heights_m.at(i, j) = 100.0F + 0.5F * static_cast<float>(i - 60);
  const auto waters =
      with_covered_water(std::nullopt, LandCover(std::move(number), classes, 4), heights_m);
  ASSERT_TRUE(waters);
  const Water water(*waters, 1);
  EXPECT_DOUBLE_EQ(water.level_m({300.0, 500.0}), 100.0);
  for (const double east_m : {760.0, 830.0, 900.0}) {
    EXPECT_DOUBLE_EQ(water.share({east_m, 500.0}, 1.0), 1.0) << east_m;
    EXPECT_NEAR(water.level_m({east_m, 500.0}), 100.0 + 0.05 * (east_m - 600.0), 1.5) << east_m;
  }
}

// Such a lake is known on a map three times as wide, of no more than so many samples.
TEST(LandCover, ItsNarrowRiversAreSeenBesideLakesOfTheModel) {
  constexpr double wide_m = 20000.0;
  GroundMap<int> number(2001, wide_m, 0);
  for (int k = 600; k <= 1400; ++k) number.at(k, k) = 2;
  Heightfield heights_m(101, wide_m);
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 101; ++i) heights_m.at(i, j) = static_cast<float>(i);
  Lakes of_model{GroundMap<int>(201, Square{{-wide_m, -wide_m}, 3.0 * wide_m}, -1), {33.0}};
  of_model.number.at(3, 3) = 0;
  const auto waters =
      with_covered_water(of_model, LandCover(std::move(number), classes, 4), heights_m);
  ASSERT_TRUE(waters);
  const Water water(*waters, 1);
  for (double along_m = 6100.0; along_m < 13900.0; along_m += 7.0)
    EXPECT_GT(width_of_diagonal_m(water, along_m, 2.0), 10.0) << along_m;
}

TEST(LandCover, HasNoWaterWhereItWouldFallAsASlope) {
  EXPECT_FALSE(with_covered_water(std::nullopt, lake(), falling(0.2)));
}

TEST(LandCover, ItsLakesStandBesideThoseOfTheModel) {
  Lakes of_model{GroundMap<int>(201, Square{{-1000.0, -1000.0}, 3000.0}, -1), {33.0}};
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) of_model.number.at(i, j) = 0;
  const auto lakes = with_covered_water(of_model, lake(), falling(0.0));
  ASSERT_TRUE(lakes);
  ASSERT_EQ(lakes->levels_m.size(), 2U);
  const Water water(*lakes, 1);
  EXPECT_DOUBLE_EQ(water.share({-900.0, -900.0}, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(water.level_m({-900.0, -900.0}), 33.0);
  EXPECT_DOUBLE_EQ(water.share({500.0, 500.0}, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(water.level_m({500.0, 500.0}), 100.0);
  EXPECT_DOUBLE_EQ(water.share({200.0, 500.0}, 1.0), 0.0);
}

class LandCoverFile : public testing::Test {
 protected:
  /// 60 x 60 cells of 20 m about the same place, `value` by column and row from the north-west.
  template <class Value>
  std::string raster(const char* name, int epsg, const Value& value) {
    GDALAllRegister();
    const std::filesystem::path file = folder_.path() / name;
    GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), 60, 60, 1, GDT_Float64, nullptr));
    std::array<double, 6> place = {5e5, 20.0, 0.0, 3.8e6, 0.0, -20.0};
    raster->SetGeoTransform(place.data());
    if (epsg != 0) {
      OGRSpatialReference system;
      system.importFromEPSG(epsg);
      raster->SetSpatialRef(&system);
    }
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 60; ++column) {
        double cell = value(column, row);
        EXPECT_EQ(raster->GetRasterBand(1)->RasterIO(GF_Write, column, row, 1, 1, &cell, 1, 1,
                                                     GDT_Float64, 0, 0),
                  CE_None);
      }
    return file.string();
  }

  scene::Terrain terrain_of(const std::string& cover) {
    scene::Terrain terrain;
    terrain.elevation =
        raster("dem.tif", 32611, [](int column, int row) { return 2.0 * column + 0.7 * row; });
    terrain.cover = cover;
    terrain.size_m = 800.0;
    terrain.samples = 65;
    return terrain;
  }

  wold::test::TemporaryFolder folder_{"land_cover"};
};

// Trees in the north-west, no other number that anybody knows.
TEST_F(LandCoverFile, LiesWhereItsCoordinatesSay) {
  const std::string file = raster("cover.tif", 32611, [](int column, int row) {
    return column < 30 && row < 30 ? 10.0 : 250.0;
  });
  const auto cover = read_land_cover(terrain_of(file), scene::cover_classes_of({}), 1);
  ASSERT_TRUE(cover);
  EXPECT_NEAR(cover->at({100.0, 700.0}).grass, 0.1, 1e-9);
  EXPECT_NEAR(cover->at({700.0, 700.0}).grass, 1.0, 1e-9);
  EXPECT_NEAR(cover->at({100.0, 100.0}).grass, 1.0, 1e-9);
}

TEST_F(LandCoverFile, IsRefusedWithoutASystemWhereTheModelHasOne) {
  const std::string file = raster("cover.tif", 0, [](int, int) { return 30.0; });
  EXPECT_THROW(read_land_cover(terrain_of(file), scene::cover_classes_of({}), 1), InputError);
}

TEST_F(LandCoverFile, IsRefusedWhereItHasNoClasses) {
  for (const double value : {0.5, 1e300, std::numeric_limits<double>::infinity()}) {
    const std::string file = raster("cover.tif", 32611, [&](int, int) { return value; });
    EXPECT_THROW(read_land_cover(terrain_of(file), scene::cover_classes_of({}), 1), InputError)
        << value;
  }
}

TEST_F(LandCoverFile, NumbersThatAreNoneSayNothing) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::string file = raster("cover.tif", 32611, [&](int, int) { return nothing; });
  const auto cover = read_land_cover(terrain_of(file), scene::cover_classes_of({}), 1);
  ASSERT_TRUE(cover);
  EXPECT_DOUBLE_EQ(cover->at({400.0, 400.0}).grass, 1.0);
}

TEST_F(LandCoverFile, MakesWaterOfTheGround) {
  const std::string file = raster("cover.tif", 32611, [](int column, int row) {
    return std::abs(column - 30) < 8 && std::abs(row - 30) < 2 ? 80.0 : 30.0;
  });
  scene::Terrain terrain = terrain_of(file);
  terrain.elevation = raster("dem.tif", 32611, [](int column, int row) {
    return 0.05 * column + 0.7 * std::abs(row - 30);
  });
  const Ground ground = make_ground(terrain, 1, scene::cover_classes_of({}));
  ASSERT_TRUE(ground.water);
  EXPECT_DOUBLE_EQ(ground.water->share({400.0, 390.0}, 1.0), 1.0);
  terrain.water = scene::WaterSource::none;
  EXPECT_FALSE(make_ground(terrain, 1, scene::cover_classes_of({})).water);
}

}  // namespace
}  // namespace wold::terrain
