// The files of a frame and of a film, without a USD library; tests/usd.sh has the stages
// themselves.
#include "usd/export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/vdb_file.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"
#include "usd/blade_files.h"
#include "usd/film_stage.h"
#include "usd/ground_file.h"
#include "usd/placement.h"
#include "usd/text.h"
#include "usd/tint.h"
#include "usd/volume_file.h"

namespace wold::usd {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// The files that a layer names, from the layer's folder on.
std::set<fs::path> named_in(const std::string& text) {
  std::set<fs::path> files;
  const std::regex name("@\\./([^@]+)@");
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at)
    files.insert((*at)[1].str());
  return files;
}

class UsdExport : public testing::Test {
 protected:
  UsdExport()
      : landscape(test::synthetic_landscape({.cells_per_side = 2, .height_voxels = 8},
                                            folder.path() / "texels")) {}

  std::string stage() const { return read_file(folder.path() / "out/frame.0001.usda"); }

  const test::TemporaryFolder folder{"usd_export"};
  landscape::Landscape landscape;
};

TEST_F(UsdExport, EveryFileThatTheStageNamesIsThereAndIsListed) {
  test::add_flakes(landscape, 40, 5.0);
  landscape.ground_details = {{ColourMap(3, 0.5), {0.2, 0.3}}};
  landscape.clouds = {{"cloud_1", {1, 1, 2}, 10.0, {0.0, 0.0, 50.0}, {0.1F, 0.0F}, {{}, {}}}};
  const std::vector<fs::path> files = export_frame(landscape, folder.path() / "out");
  const std::set<fs::path> listed(files.begin(), files.end());
  for (const fs::path& file : files) EXPECT_TRUE(fs::is_regular_file(file)) << file;
  const std::set<fs::path> named = named_in(stage());
  for (const fs::path& file : named)
    EXPECT_TRUE(listed.contains(folder.path() / "out" / file)) << file;
  EXPECT_GE(named.size(), 10U);
}

TEST_F(UsdExport, EveryCellIsAnInstance) {
  export_frame(landscape, folder.path() / "out");
  EXPECT_EQ(count(stage(), "instanceable = true"),
            landscape.cells.size() + landscape.blade_cells.size());
}

// USD cuts no volume: a cell in quarters is one instance, where its quarters lie on average.
TEST_F(UsdExport, ACellInPartsIsOneInstance) {
  landscape.blade_cells.clear();
  const glm::dmat4 place = landscape.cells[0].world_from_cell;
  const int volume = landscape.cells[0].volume;
  landscape.cells.clear();
  for (const double x : {0.0, 0.5}) {
    landscape::Cell half{place, volume};
    half.part = {{x, 0.0}, {x + 0.5, 1.0}};
    half.world_from_cell[3].z += x;
    landscape.cells.push_back(half);
  }
  export_frame(landscape, folder.path() / "out");
  EXPECT_EQ(count(stage(), "instanceable = true"), 1U);
  Placement mean = placement_of(place);
  mean.outer[3].z += 0.25;
  EXPECT_THAT(stage(), HasSubstr(matrix(mean.outer)));
}

TEST_F(UsdExport, WhatTheFrameHasNoMoreLeavesNoFile) {
  landscape::Landscape more = landscape;
  more.clouds = {{"cloud_1", {1, 1, 1}, 10.0, {0.0, 0.0, 50.0}, {0.1F}, {{}}}};
  more.ground_details = {{ColourMap(3, 0.5), {0.2, 0.3}}};
  export_frame(more, folder.path() / "out");
  const fs::path data = folder.path() / "out/data/frame_0001";
  EXPECT_TRUE(fs::exists(data / "cloud_1.vdb"));
  EXPECT_TRUE(fs::exists(data / "ground_detail_1.exr"));
  export_frame(landscape, folder.path() / "out");
  EXPECT_FALSE(fs::exists(data / "cloud_1.vdb"));
  EXPECT_FALSE(fs::exists(data / "ground_detail_1.exr"));
}

TEST_F(UsdExport, ALandscapeOfBakedLightAloneIsRefused) {
  landscape.unlit.reset();
  EXPECT_THROW(export_frame(landscape, folder.path() / "out"), InputError);
}

// What lets light through sends all of it back: a surface of USD lets nothing through.
TEST_F(UsdExport, LitBladesHaveReflectanceAndTransmittance) {
  write_blades(landscape.blade_meshes[0], folder.path());
  const Image picture = read_image(folder.path() / blades_reflectance("pillar"));
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.height, 1);
  EXPECT_NEAR(picture.pixel(0, 0)[1], 0.5, 1e-3);
}

TEST_F(UsdExport, BladesOfRadianceAloneHaveNoReflectance) {
  auto tubes = std::make_shared<Tubes>(*landscape.blade_meshes[0].tubes);
  tubes->reflectance.clear();
  landscape.blade_meshes[0].tubes = tubes;
  export_frame(landscape, folder.path() / "out");
  EXPECT_THAT(stage(), testing::Not(HasSubstr("pillar_reflectance")));
}

// Its value lies in the middle of a voxel, as it does in the texel's own file.
TEST_F(UsdExport, VolumesKeepTheirPlaceAndGainWhatTheyGain) {
  const landscape::Volume& volume = landscape.volumes[0];
  write_volume(volume, folder.path());
  const fs::path file = folder.path() / (volume_name(volume) + ".vdb");
  const auto density = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(file, "density"));
  const auto emission = openvdb::gridPtrCast<openvdb::Vec3SGrid>(read_vdb_grid(file, "emission"));
  const auto radiance =
      openvdb::gridPtrCast<openvdb::Vec3SGrid>(read_vdb_grid(volume.vdb, volume.emission_grid));
  const openvdb::Vec3d first = density->indexToWorld(openvdb::Coord(1));
  EXPECT_NEAR(first.x(), 0.5 * volume.voxel_m, 1e-9);
  EXPECT_EQ(density->activeVoxelCount(), emission->activeVoxelCount());
  EXPECT_GT(density->activeVoxelCount(), 0U);
  for (auto at = emission->cbeginValueOn(); at; ++at) {
    const double wanted = density->tree().getValue(at.getCoord()) *
                          double{radiance->tree().getValue(at.getCoord()).y()};
    ASSERT_NEAR((*at).y(), wanted, 2e-3 * wanted);
  }
}

// The value on the terrain's corner is the middle of the picture's corner pixel.
TEST(UsdGround, ItsPictureLiesOnTheCorners) {
  const Heightfield terrain(5, 40.0);
  const PicturePlace all = place_in(terrain, Square{{0.0, 0.0}, 40.0}, 9);
  EXPECT_NEAR(all.offset.x, 0.5 / 9.0, 1e-12);
  EXPECT_NEAR(all.scale.y + all.offset.y, 8.5 / 9.0, 1e-12);
  const PicturePlace part = place_in(terrain, Square{{10.0, 20.0}, 10.0}, 3);
  const glm::dvec2 corner_st(0.25, 0.5);
  EXPECT_NEAR(part.scale.x * corner_st.x + part.offset.x, 0.5 / 3.0, 1e-12);
  EXPECT_NEAR(part.scale.y * corner_st.y + part.offset.y, 0.5 / 3.0, 1e-12);
}

// Neither of the two transforms shears: its directions are square to each other.
TEST(UsdPlacement, AShearedCellIsTwoTransformsWithoutShear) {
  const glm::dmat4 cell({0, 1, 0.4, 0}, {-1, 0, 0.3, 0}, {0.1, -0.2, 0.9, 0}, {3, 4, 5, 1});
  const Placement placement = placement_of(cell);
  const glm::dmat4 product = placement.outer * placement.inner;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(product[i][j], cell[i][j], 1e-12) << i << " " << j;
  for (const glm::dmat4& each : {placement.outer, placement.inner})
    for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 0}})
      EXPECT_NEAR(glm::dot(glm::dvec3(each[a]), glm::dvec3(each[b])), 0.0, 1e-12);
}

TEST(UsdLight, AStepIsAtMostAFifthOfAnOctaveAwayAndKeepsTheMean) {
  const test::TemporaryFolder folder("usd_light");
  landscape::Landscape landscape = test::synthetic_landscape({.cells_per_side = 6}, folder.path());
  landscape.blade_cells.clear();
  landscape.light = ColourMap(2, 3.0);
  for (int i = 0; i < 2; ++i) landscape.light.at(0, i) = {0.4F, 0.4F, 0.6F};
  for (int i = 0; i < 2; ++i) landscape.light.at(1, i) = {1.6F, 1.4F, 1.2F};
  for (const landscape::Cell& cell : landscape.cells)
    landscape.blade_cells.push_back({cell.world_from_cell, 0});
  const CellLight cells(landscape);
  glm::dvec3 light(0.0), tints(0.0);
  for (std::size_t i = 0; i < landscape.blade_cells.size(); ++i) {
    const double x_m = landscape.blade_cells[i].world_from_cell[3].x + 0.25;
    const glm::dvec3 here(landscape.light.sample(x_m, 0.0));
    const glm::dvec3 tint = cells.tint_of(cells.step_of(i));
    EXPECT_LE(std::abs(std::log2(tint.y / here.y)), 1.0 / 5.0);
    light += here;
    tints += tint;
  }
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(tints[channel], light[channel], 1e-6 * light[channel]);
}

TEST(UsdText, NumbersAreShort) {
  EXPECT_EQ(rounded(0.1234567, 5), "0.12346");
  EXPECT_EQ(rounded(2.5, 4), "2.5");
  EXPECT_EQ(rounded(30.0, 4), "30");
  EXPECT_EQ(rounded(-0.000001, 4), "0");
  EXPECT_THROW(number(NAN), FileError);
}

TEST(UsdFilm, EveryFrameOfTheFilmIsNamedWhetherItIsMadeOrNot) {
  const test::TemporaryFolder folder("usd_film");
  const exporter::FrameMoment film[] = {{1, 0.1, 0.0}, {2, 0.8, 60.0}, {3, 0.5, 120.0}};
  write_film_stage(film, folder.path());
  const std::string text = read_file(folder.path() / "scene.usda");
  EXPECT_THAT(named_in(text),
              ElementsAre("camera.usda", "frame.0001.usda", "frame.0002.usda", "frame.0003.usda"));
  EXPECT_THAT(text, HasSubstr("endTimeCode = 3"));
}

TEST_F(UsdExport, BouldersAreTrianglesOfTheGround) {
  const auto ground_text = [&] {
    return read_file(folder.path() / "out" / write_ground(landscape, folder.path() / "out"));
  };
  fs::create_directories(folder.path() / "out");
  const auto counts_in = [](const std::string& text) {
    const std::size_t begin = text.find("faceVertexCounts");
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  const std::string before = counts_in(ground_text());
  landscape.boulders.points_m = {{1, 1, 2}, {0.5F, 0.5F, 1}, {1.5F, 0.5F, 1}, {1, 1.5F, 1}};
  landscape.boulders.origin_m = {-1, 0, 5};
  for (glm::vec3& from_origin_m : landscape.boulders.points_m) from_origin_m -= glm::vec3(-1, 0, 5);
  landscape.boulders.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  const std::string text = ground_text();
  EXPECT_EQ(counts_in(text), before.substr(0, before.size() - 1) + ", 3, 3, 3]");
  EXPECT_THAT(text, HasSubstr("(1, 1, 2), (0.5, 0.5, 1), (1.5, 0.5, 1), (1, 1.5, 1)]"));
  EXPECT_THAT(text, HasSubstr("(0, 0, 1), (-0.743, -0.371, 0.557), (0.743, -0.371, 0.557), "
                              "(0, 0.894, 0.447)]"));
}

}  // namespace
}  // namespace wold::usd
