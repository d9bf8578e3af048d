#include "povray/export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

#include "core/colour.h"
#include "core/df3.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/vdb_dense.h"
#include "povray/ground_files.h"
#include "povray/volume_files.h"
#include "support/povray_film.h"
#include "support/synthetic_landscape.h"

namespace wold::povray {
namespace {
namespace fs = std::filesystem;

class Export : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             (std::string("wold_povray_") +
              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    scene = test::synthetic_landscape({}, folder / "texels");
  }
  void TearDown() override { fs::remove_all(folder); }

  static std::map<std::string, std::string> contents(const fs::path& root) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root))
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), root).string()] = read_file(entry.path());
    return files;
  }

  fs::path folder;
  landscape::Landscape scene;
};

/// What POV-Ray's trilinear pattern shows at a point of cell space (in voxels), by its definition:
/// sample i of n at i/n of the box, and the box begins one half voxel below the cell's corner.
float shown(const std::vector<float>& samples, glm::ivec3 size, glm::dvec3 at_voxels) {
  const glm::dvec3 at = at_voxels + 0.5;
  const glm::ivec3 low(glm::floor(at));
  const glm::dvec3 part = at - glm::dvec3(low);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::ivec3 i = (low + step) % size;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] ? part[axis] : 1.0 - part[axis];
    sum += weight * samples[static_cast<std::size_t>((i.z * size.y + i.y) * size.x + i.x)];
  }
  return static_cast<float>(sum);
}

TEST_F(Export, PaddedVolumeShowsVoxelsAtTheirCentresAndTiles) {
  const glm::ivec3 voxels(3, 2, 2);
  const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const std::vector<float> samples = padded(values, voxels);
  const glm::ivec3 size = padded_size(voxels);
  EXPECT_FLOAT_EQ(shown(samples, size, {0.5, 0.5, 0.5}), 1.0F);
  EXPECT_FLOAT_EQ(shown(samples, size, {2.5, 1.5, 1.5}), 12.0F);
  for (double y : {0.2, 1.0, 1.7})  // both sides of the seam, which lies between voxels 3 and 1
    EXPECT_FLOAT_EQ(shown(samples, size, {0.0, y, 0.9}), shown(samples, size, {3.0, y, 0.9}));
  EXPECT_FLOAT_EQ(shown(samples, size, {0.0, 0.5, 0.5}), 2.0F);  // (3 + 1) / 2
  EXPECT_FLOAT_EQ(shown(samples, size, {0.5, 0.5, 0.0}), 1.0F);  // the ground is not thin
  EXPECT_FLOAT_EQ(shown(samples, size, {2.5, 1.5, 2.0}), 6.0F);  // half of the top slice
  EXPECT_FLOAT_EQ(shown(samples, size, {2.5, 1.5, 2.5}), 0.0F);  // nothing of the bottom one
}

/// A value of a padded grid, which begins one voxel before the first.
float sample(const Df3& grid, int x, int y, int z) {
  return grid
      .values[static_cast<std::size_t>(((z + 1) * grid.size.y + y + 1) * grid.size.x + x + 1)];
}

TEST_F(Export, VolumeIsRestoredByItsScales) {
  export_frame(scene, folder / "povray");
  const landscape::Volume& volume = scene.volumes[1];
  auto extinction = read_dense_floats(volume.vdb, "density", glm::ivec3(1), volume.voxels);
  const int height = filled_height(extinction, volume.voxels, fraction_of_tips);
  const glm::ivec3 voxels(volume.voxels.x, volume.voxels.y, height);
  extinction.resize(static_cast<std::size_t>(voxels.x * voxels.y * voxels.z));
  const auto radiance = read_dense_vectors(volume.vdb, "emission_q0", glm::ivec3(1), voxels);
  const fs::path volumes = folder / "povray/data/volumes";
  const Df3 density = read_df3(volumes / (density_name(volume) + ".df3"));
  const Df3 bright = read_df3(volumes / (volume.name + "_l.df3"));
  const Df3 green = read_df3(volumes / (volume.name + "_g.df3"));
  ASSERT_EQ(density.size, voxels + 2);
  ASSERT_EQ(bright.size, voxels + 2);
  ASSERT_EQ(green.size, glm::ivec3(voxels.x / 2, voxels.y / 2, voxels.z / 2 + 1) + 2);
  const auto luminance_at = [&](std::size_t i) {
    return extinction[i] * static_cast<float>(luminance(radiance[i]));
  };
  const float extinction_max = *std::ranges::max_element(extinction);
  float luminance_max = 0.0F;
  for (std::size_t i = 0; i < extinction.size(); ++i)
    luminance_max = std::max(luminance_max, luminance_at(i));
  // Blades of this landscape have one colour, brighter and darker.
  const auto colour = static_cast<float>(0.10 / luminance({0.03, 0.10, 0.015}));
  const float green_max = colour;
  for (int z = 0; z < height; z += 5)
    for (int x = 0; x < voxels.x; ++x) {
      const auto i = static_cast<std::size_t>((z * voxels.y + 7) * voxels.x + x);
      EXPECT_NEAR(sample(density, x, 7, z) * extinction_max, extinction[i], extinction_max / 500);
      EXPECT_NEAR(sample(bright, x, 7, z) * luminance_max, luminance_at(i), luminance_max / 500);
      EXPECT_NEAR(sample(green, x / 2, 7 / 2, z / 2) * green_max, colour, colour / 100);
    }
}

TEST_F(Export, LeavesOutTheTipsOfABladeOrTwo) {
  const glm::ivec3 voxels(10, 10, 4);
  std::vector<float> values(400, 0.0F);
  std::fill_n(values.begin(), 200, 1.0F);
  values[250] = 0.09F;
  EXPECT_EQ(filled_height(values, voxels), 3);
  EXPECT_EQ(filled_height(values, voxels, 0.0005), 2);
  EXPECT_EQ(filled_height(values, voxels, 0.0004), 3);
  EXPECT_EQ(filled_height(std::vector<float>(400, 0.0F), voxels, 0.0005), 1);
}

// Light differs with the sun's turn, matter does not.
TEST_F(Export, VolumesOfOneTexelShareItsExtinction) {
  landscape::Volume turned = scene.volumes[0];
  turned.name += "_turned";
  scene.volumes.push_back(turned);
  scene.cells.back().volume = static_cast<int>(scene.volumes.size()) - 1;
  export_frame(scene, folder / "povray");
  const fs::path volumes = folder / "povray/data/volumes";
  EXPECT_TRUE(fs::exists(volumes / (turned.name + "_r.df3")));
  const auto is_extinction = [](const auto& file) { return file.first.ends_with("_d.df3"); };
  EXPECT_EQ(std::ranges::count_if(contents(volumes), is_extinction),
            static_cast<int>(scene.volumes.size()) - 1);
  EXPECT_THAT(read_file(folder / "povray/data/frame_0001/volumes.inc"),
              testing::HasSubstr("\"" + turned.name + "\", 0)"));
}

TEST_F(Export, SameLandscapeSameBytes) {
  export_frame(scene, folder / "one");
  export_frame(scene, folder / "two");
  EXPECT_EQ(contents(folder / "one"), contents(folder / "two"));
}

TEST_F(Export, WritesOnlyVolumesThatCellsUseAndNoneTwice) {
  for (landscape::Cell& cell : scene.cells) cell.volume = 1;
  export_frame(scene, folder / "povray");
  const fs::path volumes = folder / "povray/data/volumes";
  EXPECT_FALSE(fs::exists(volumes / (scene.volumes[0].name + ".inc")));
  const fs::path grid = volumes / (density_name(scene.volumes[1]) + ".df3");
  const std::string bytes = read_file(grid);
  const auto written = fs::last_write_time(grid);
  export_frame(scene, folder / "povray");
  EXPECT_EQ(fs::last_write_time(grid), written) << "an unchanged volume was written again";
  scene.volumes[1].content = "changed";
  export_frame(scene, folder / "povray");
  EXPECT_GT(fs::last_write_time(grid), written) << "a changed volume was not written again";
  write_file(grid, "damaged");
  export_frame(scene, folder / "povray");
  EXPECT_EQ(read_file(grid), bytes);
}

// Half of the grids new, half old: the next run must not take them for whole.
TEST_F(Export, AnInterruptedVolumeIsWrittenAgain) {
  export_frame(scene, folder / "povray");
  landscape::Volume& volume = scene.volumes[0];
  const fs::path blue = folder / "povray/data/volumes" / (volume.name + "_b.df3");
  const std::string bytes = read_file(blue);
  const std::string content = volume.content;
  volume.content = "changed";
  fs::remove(blue);
  fs::create_directory(blue);  // writing stops here
  EXPECT_THROW(export_frame(scene, folder / "povray"), FileError);
  fs::remove(blue);
  write_file(blue, "old");
  volume.content = content;
  export_frame(scene, folder / "povray");
  EXPECT_EQ(read_file(blue), bytes);
}

// Where east, north and up of a cell point to, and its corner, in this order.
TEST_F(Export, CellsStandWhereTheLandscapeHasThem) {
  landscape::Cell cell = scene.cells.front();
  cell.world_from_cell = glm::dmat4({0, 1, 0.25, 0}, {-1, 0, 0.5, 0}, {0, 0, 2, 0}, {3, 4, 5, 1});
  scene.cells = {cell};
  scene.blade_cells.front().world_from_cell = cell.world_from_cell;
  export_frame(scene, folder / "povray");
  EXPECT_EQ(read_file(folder / "povray/data/frame_0001/cells.txt"),
            "1,\n"
            "0, 0, <0, 1, 0.25>, <-1, 0, 0.5>, <0, 0, 2>, <3, 4, 5>, <0, 0, 0>, <1, 1, 0>,\n"
            "1,\n"
            "0, 0, <0, 1, 0.25>, <-1, 0, 0.5>, <0, 0, 2>, <3, 4, 5>,\n");
}

// The brightest of all maps is the largest number of all files.
TEST_F(Export, FinerLightIsSaidAndWrittenAndGoesWithTheNextRun) {
  const fs::path frame = folder / "povray/data/frame_0001";
  const auto is_written = [&](const std::string& name) { return fs::exists(frame / name); };
  const glm::vec3 brightest(0.5F, 9.0F, 2.0F);
  scene.light_details = {ColourMap(5, {glm::dvec2(-3.0, -4.0), 12.0}, brightest)};
  const std::vector<fs::path> files = export_frame(scene, folder / "povray", 16);
  const std::string text = read_file(frame / "frame.inc");
  EXPECT_THAT(text, testing::HasSubstr("Wold_light_detail = array[1][4] {\n  { -6, -7, 7, 3 },\n"));
  EXPECT_THAT(text, testing::ContainsRegex("Wold_light_max = <[0-9.]+, 9, "));
  for (const char* name : {"light_1_r.df3", "light_1_b.df3", "blade_light_1_g.df3"}) {
    EXPECT_TRUE(is_written(name)) << name;
    EXPECT_THAT(files, testing::Contains(frame / name));
  }
  scene.light_details.clear();
  export_frame(scene, folder / "povray", 16);
  EXPECT_FALSE(is_written("light_1_r.df3"));
  EXPECT_FALSE(is_written("blade_light_1_g.df3"));
  EXPECT_TRUE(is_written("light_r.df3"));
  EXPECT_THAT(read_file(frame / "frame.inc"), testing::Not(testing::HasSubstr("light_detail")));
}

// Cells stand on squares of ground that are cut from south-west to north-east (terrain/relief.h).
TEST_F(Export, GroundIsCutFromSouthWestToNorthEast) {
  const int n = 3;
  const std::string name = write_terrain(Heightfield(n, 2.0, 0.0F), folder);
  const std::string text = read_file(folder / name);
  std::istringstream numbers(text.substr(text.find("face_indices")));
  std::vector<int> indices;
  for (char c; numbers.get(c);)
    if (c == '<' || c == ',')
      if (int index = 0; numbers.peek() != '<' && numbers >> index) indices.push_back(index);
  ASSERT_EQ(indices.size(), 3U * 2 * (n - 1) * (n - 1));
  for (int square = 0; square < (n - 1) * (n - 1); ++square) {
    const int south_west = square / (n - 1) * n + square % (n - 1);
    for (int half = 0; half < 2; ++half) {
      const auto first = indices.begin() + 6 * square + 3 * half;
      EXPECT_EQ(std::count(first, first + 3, south_west), 1);
      EXPECT_EQ(std::count(first, first + 3, south_west + n + 1), 1);
    }
  }
}

// POV-Ray's v rises from the lower edge of a picture, whose rows begin with the upper one.
TEST_F(Export, BladesHaveTheirOwnColours) {
  Tubes tubes{.rings = 1, .corners = 3, .vertices_m = {}, .radiance = {}};
  for (int tube = 0; tube < 4; ++tube) {
    for (int corner = 0; corner < 3; ++corner) tubes.vertices_m.emplace_back(tube, corner, 0);
    tubes.radiance.emplace_back(0.125F * static_cast<float>(tube), 0.5F, 1.0F);
  }
  scene.blade_meshes[0].name = "four";
  scene.blade_meshes[0].tubes = std::make_shared<const Tubes>(tubes);
  export_frame(scene, folder / "povray");
  const std::string text = read_file(folder / "povray/data/blades/four.inc");
  const Image picture = read_image(folder / "povray/data/blades/four.exr");
  std::size_t at = text.find("uv_vectors");
  for (int vertex = 0; vertex < 12; ++vertex) {
    at = text.find(",<", at) + 2;
    const double v = std::stod(text.substr(text.find(',', at) + 1));
    const int row = static_cast<int>((1.0 - v) * picture.height);
    EXPECT_EQ(picture.pixel(0, row)[0], 0.125F * static_cast<float>(vertex / 3));
  }
}

// A folder of an older wold has meshes that are written otherwise, under the same names.
TEST_F(Export, BladesOfAnotherLayoutAreWrittenAgain) {
  export_frame(scene, folder / "povray");
  const fs::path mesh = folder / "povray/data/blades" / (scene.blade_meshes[0].name + ".inc");
  const std::string bytes = read_file(mesh);
  write_file(mesh, "// Blades of grass: centimetres, z up.\n#declare Mesh = mesh2 {}\n");
  export_frame(scene, folder / "povray");
  EXPECT_EQ(read_file(mesh), bytes);
}

// It lists the film, not what there is: whoever writes it writes the same.
TEST_F(Export, IndexListsAllFramesOfTheFilm) {
  const std::vector<FrameMoment> film = {{1, 0.0, 0.0}, {2, 0.25, 1800.0}, {3, 0.917, 86400.5}};
  export_scene(film, folder / "povray");
  const std::string index = read_file(folder / "povray/data/frames.inc");
  EXPECT_THAT(index, testing::HasSubstr("Wold_frames = array[3][3]"));
  for (const char* row : {"{ 1, 0, 0 }", "{ 2, 0.25, 1800 }", "{ 3, 0.917, 86400.5 }"})
    EXPECT_THAT(index, testing::HasSubstr(row));
  const auto written = fs::last_write_time(folder / "povray/data/frames.inc");
  export_frame(scene, folder / "povray");
  export_scene(film, folder / "povray");
  EXPECT_EQ(fs::last_write_time(folder / "povray/data/frames.inc"), written);
}

TEST_F(Export, WhatIsNoNumberIsAFileError) {
  scene.camera.eye_m.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(export_frame(scene, folder / "povray"), FileError);
}

TEST_F(Export, UnwritableFolderIsAFileErrorAndLeavesNothing) {
  write_file(folder / "occupied", "a file where a folder should be");
  const auto before = contents(folder);
  EXPECT_THROW(export_frame(scene, folder / "occupied"), FileError);
  EXPECT_THROW(export_scene(test::film_of(scene), folder / "occupied"), FileError);
  EXPECT_EQ(contents(folder), before);
}

TEST_F(Export, MissingVolumeIsAFileErrorThatNamesIt) {
  fs::remove(scene.volumes[0].vdb);
  try {
    export_frame(scene, folder / "povray");
    FAIL() << "a missing volume was accepted";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(scene.volumes[0].name), std::string::npos)
        << error.what();
  }
}

TEST_F(Export, BouldersAreAMeshOfTheirOwnWhereThereAreSome) {
  std::vector<fs::path> files = export_frame(scene, folder / "out", 16);
  const fs::path frame_inc = folder / "out/data/frame_0001/frame.inc";
  EXPECT_THAT(read_file(frame_inc), Not(testing::HasSubstr("boulders")));
  scene.boulders.points_m = {{1, 1, 2}, {0.5F, 0.5F, 1}, {1.5F, 0.5F, 1}, {1, 1.5F, 1}};
  scene.boulders.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  scene.boulders.origin_m = {100, 200, 30};
  files = export_frame(scene, folder / "out", 16);
  const auto file = std::ranges::find_if(files, [](const fs::path& path) {
    return path.filename().string().starts_with("boulders_");
  });
  ASSERT_NE(file, files.end());
  EXPECT_THAT(read_file(frame_inc),
              testing::HasSubstr("Wold_boulders_file = \"" + file->filename().string() + "\";"));
  EXPECT_THAT(read_file(frame_inc), testing::HasSubstr("Wold_boulders_origin_m = <100, 200, 30>;"));
  const std::string text = read_file(*file);
  EXPECT_THAT(text, testing::HasSubstr("#declare Wold_boulders_mesh = mesh2 {"));
  EXPECT_THAT(text, testing::HasSubstr("vertex_vectors { 4,\n<1,1,2>,\n<0.5,0.5,1>,"));
  EXPECT_THAT(text, testing::HasSubstr("face_indices { 3,\n<0,1,2>,\n<0,2,3>,\n<0,3,1>"));
}

}  // namespace
}  // namespace wold::povray
