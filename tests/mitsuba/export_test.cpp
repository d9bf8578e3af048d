// The files of a frame, without Mitsuba.
#include "mitsuba/export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <regex>
#include <set>

#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "mitsuba/grid_file.h"
#include "mitsuba/leaf_files.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::mitsuba {
namespace {

namespace fs = std::filesystem;

/// A tube of three corners along z whose outline is as long as a circle's of that radius.
Tubes upright_tube(double radius_m, const glm::vec3& transmittance) {
  Tubes tubes{2, 3, {}, {}};
  const double reach_m = radius_m * std::numbers::pi / (3.0 * std::sin(std::numbers::pi / 3.0));
  for (const double z : {0.0, 1.0})
    for (int corner = 0; corner < 3; ++corner) {
      const double angle = 2.0 * std::numbers::pi * corner / 3.0;
      tubes.vertices_m.emplace_back(reach_m * std::cos(angle), reach_m * std::sin(angle), z);
    }
  tubes.radiance.assign(2, glm::vec3(0.0F));
  tubes.reflectance.assign(2, glm::vec3(0.4F));
  tubes.transmittance.assign(2, transmittance);
  return tubes;
}

class MitsubaExport : public testing::Test {
 protected:
  MitsubaExport()
      : landscape(test::synthetic_landscape({.cells_per_side = 2, .height_voxels = 8},
                                            folder.path() / "texels")) {}

  std::string scene() const { return read_file(folder.path() / "out/data/frame_0001/scene.xml"); }

  const test::TemporaryFolder folder{"mitsuba_export"};
  landscape::Landscape landscape;
};

TEST_F(MitsubaExport, EveryFileThatTheSceneNamesIsThereAndIsListed) {
  const std::vector<fs::path> files = export_frame(landscape, folder.path() / "out");
  const std::set<fs::path> listed(files.begin(), files.end());
  for (const fs::path& file : files) EXPECT_TRUE(fs::is_regular_file(file)) << file;
  const std::string text = scene();
  const std::regex name("name=\"filename\" value=\"([^\"]+)\"");
  int count = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at, ++count) {
    const fs::path named = folder.path() / "out/data/frame_0001" / (*at)[1].str();
    EXPECT_TRUE(listed.contains(named.lexically_normal())) << named;
  }
  EXPECT_GE(count, 6);
}

TEST_F(MitsubaExport, EveryCellIsABoxAndEveryBladeCellAnInstance) {
  export_frame(landscape, folder.path() / "out");
  const std::string text = scene();
  const auto count = [&](const std::string& what) {
    std::size_t found = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<shape type=\"cube\">"), landscape.cells.size());
  EXPECT_EQ(count("<shape type=\"instance\">"), landscape.blade_cells.size());
  EXPECT_EQ(count("<shape type=\"shapegroup\""), landscape.blade_meshes.size());
  EXPECT_THAT(text, testing::HasSubstr("<default name=\"exposure_gain\" value=\"4\"/>"));
}

TEST_F(MitsubaExport, CloudsThatAreGoneLeaveNoFile) {
  landscape::Landscape cloudy = landscape;
  cloudy.clouds = {{"cloud_1", {2, 2, 2}, 10.0, {0.0, 0.0, 50.0}, {}, {}}};
  cloudy.clouds.front().extinction_per_m.assign(8, 0.01F);
  export_frame(cloudy, folder.path() / "out");
  const fs::path cloud = folder.path() / "out/data/frame_0001/cloud_1.vol";
  EXPECT_TRUE(fs::exists(cloud));
  EXPECT_THAT(scene(), testing::HasSubstr("value=\"cloud_1.vol\""));
  export_frame(landscape, folder.path() / "out");
  EXPECT_FALSE(fs::exists(cloud));
}

TEST_F(MitsubaExport, ALandscapeOfBakedLightAloneIsRefused) {
  landscape.unlit.reset();
  EXPECT_THROW(export_frame(landscape, folder.path() / "out"), InputError);
}

TEST_F(MitsubaExport, BladesOfRadianceAloneAreRefused) {
  auto tubes = std::make_shared<Tubes>(*landscape.blade_meshes[0].tubes);
  tubes->reflectance.clear();
  landscape.blade_meshes[0].tubes = tubes;
  EXPECT_THROW(export_frame(landscape, folder.path() / "out"), InputError);
}

// A leaf that lets light through is one surface, half as wide as the outline is long.
TEST(MitsubaLeaves, AThinLeafIsARibbonOfHalfTheOutline) {
  const Mesh mesh = leaf_mesh(upright_tube(0.003, glm::vec3(0.3F)));
  ASSERT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_NEAR(glm::distance(mesh.vertices[0].place_m, mesh.vertices[1].place_m),
              std::numbers::pi * 0.003, 1e-7);
  EXPECT_EQ(mesh.vertices[0].uv, glm::vec2(0.25F, 0.5F));
  EXPECT_EQ(mesh.vertices[3].uv, glm::vec2(0.75F, 0.5F));
}

TEST(MitsubaLeaves, WhatLetsNoLightThroughStaysATube) {
  const Mesh mesh = leaf_mesh(upright_tube(0.003, glm::vec3(0.0F)));
  EXPECT_EQ(mesh.vertices.size(), 6U);
  EXPECT_EQ(mesh.triangles.size(), 6U);
}

TEST(MitsubaGrid, HeaderAndValuesLieWhereMitsubaReadsThem) {
  const std::string bytes = grid_bytes({2, 1, 1}, std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}});
  ASSERT_EQ(bytes.size(), 48U + 24U);
  EXPECT_EQ(bytes.substr(0, 4), "VOL\3");
  std::int32_t numbers[5];
  std::memcpy(numbers, bytes.data() + 4, sizeof(numbers));
  EXPECT_THAT(numbers, testing::ElementsAre(1, 2, 1, 1, 3));
  float values[6];
  std::memcpy(values, bytes.data() + 48, sizeof(values));
  EXPECT_THAT(values, testing::ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THROW(grid_bytes({2, 2, 2}, std::vector<float>(7)), std::invalid_argument);
}

TEST_F(MitsubaExport, BouldersAreAMeshOfTheirOwnWithTheGroundsPicture) {
  export_frame(landscape, folder.path() / "out");
  EXPECT_THAT(scene(), Not(testing::HasSubstr("boulders_")));
  landscape.boulders.points_m = {{1, 1, 2}, {0.5F, 0.5F, 1}, {1.5F, 0.5F, 1}, {1, 1.5F, 1}};
  landscape.boulders.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  const std::vector<fs::path> files = export_frame(landscape, folder.path() / "out");
  const auto file = std::ranges::find_if(files, [](const fs::path& path) {
    return path.filename().string().starts_with("boulders_");
  });
  ASSERT_NE(file, files.end());
  EXPECT_THAT(scene(), testing::HasSubstr("\"../" + file->filename().string() + "\""));
  const std::string text = read_file(*file);
  EXPECT_THAT(text, testing::HasSubstr("element vertex 4"));
  EXPECT_THAT(text, testing::HasSubstr("element face 3"));
}

}  // namespace
}  // namespace wold::mitsuba
