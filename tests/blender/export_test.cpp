#include "blender/export.h"

#include <gtest/gtest.h>
#include <openvdb/tools/Morphology.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "blender/volume_file.h"
#include "core/colour.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/vdb_file.h"
#include "support/quartered.h"
#include "support/synthetic_landscape.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

class BlenderExport : public testing::Test {
 protected:
  BlenderExport() {
    fs::remove_all(folder);
    landscape = test::synthetic_landscape({.cells_per_side = 3, .height_voxels = 10, .volumes = 3},
                                          folder / "texels");
    for (landscape::Cell& cell : landscape.cells) cell.volume %= 2;  // the third goes unused
  }
  ~BlenderExport() override { fs::remove_all(folder); }

  nlohmann::json frame_json() const {
    return nlohmann::json::parse(read_file(folder / "out/data/frame_0001/frame.json"));
  }

  template <class T>
  std::vector<T> array(const std::string& name) const {
    const std::string bytes = read_file(folder / "out/data/frame_0001" / name);
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  const fs::path folder =
      fs::path(testing::TempDir()) / ("wold_blender_export_" + std::to_string(::getpid()));
  landscape::Landscape landscape;
};

std::map<std::string, std::string> all_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder)] = read_file(entry.path());
  return files;
}

TEST_F(BlenderExport, ArraysAndJsonSayWhatTheLandscapeSays) {
  test::quarter_cells(landscape);
  export_frame(landscape, folder / "out");
  const auto frame = frame_json();
  EXPECT_EQ(frame["size_px"], nlohmann::json({landscape.width_px, landscape.height_px}));
  EXPECT_EQ(frame["exposure_gain"], landscape.exposure_gain);
  EXPECT_EQ(frame["camera"]["eye_m"][2], landscape.camera.eye_m.z);
  EXPECT_EQ(array<float>(frame["terrain"]["heights"]), landscape.terrain.values());
  const auto positions_m = array<float>(frame["cells"]["positions"]);
  const auto picks = array<int>(frame["cells"]["picks"]);
  const auto middles_m = array<float>(frame["cells"]["part_middles"]);
  const auto halves_m = array<float>(frame["cells"]["part_halves"]);
  ASSERT_EQ(positions_m.size(), 3 * landscape.cells.size());
  for (std::size_t i = 0; i < landscape.cells.size(); ++i) {
    const landscape::Cell& cell = landscape.cells[i];
    const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
    const auto pick = static_cast<std::size_t>(picks.at(i));
    EXPECT_EQ(frame["volumes"][pick]["file"], "../volumes/" + volume.name + ".vdb");
    const auto quarter = frame["volumes"][pick]["quarter"];
    EXPECT_EQ(quarter.is_null(), cell.part.is_whole());
    if (!quarter.is_null()) {
      EXPECT_EQ(quarter, (cell.part.low.x > 0.0 ? 1 : 0) + (cell.part.low.y > 0.0 ? 2 : 0));
    }
    for (int axis = 0; axis < 2; ++axis) {
      const auto at = 3 * i + static_cast<std::size_t>(axis);
      const double low = (middles_m[at] - halves_m[at]) / landscape.patch_m;
      const double high = (middles_m[at] + halves_m[at]) / landscape.patch_m;
      EXPECT_NEAR(std::max(low, 0.0), cell.part.low[axis], 1e-6);
      EXPECT_NEAR(std::min(high, 1.0), cell.part.high[axis], 1e-6);
      // At its patch's sides a cell goes on, up to a patch farther: its neighbour comes up there.
      if (cell.part.low[axis] == 0.0) {
        EXPECT_NEAR(low, -1.0, 1e-6);
      }
      if (cell.part.high[axis] == 1.0) {
        EXPECT_NEAR(high, 2.0, 1e-6);
      }
    }
    for (int axis = 0; axis < 3; ++axis)  // nudged by at most 0.03 voxels
      EXPECT_NEAR(positions_m[3 * i + static_cast<std::size_t>(axis)],
                  cell.world_from_cell[3][axis], 0.031 * volume.voxel_m);
  }
}

// Where cells lean away from each other they are wider than their squares.
TEST_F(BlenderExport, CellsReachToTheirNeighbours) {
  landscape::Cell& cell = landscape.cells[4];
  cell.world_from_cell = glm::dmat4(1.0);
  cell.reach = glm::dmat4(glm::dmat3(1.25));
  export_frame(landscape, folder / "out");
  const auto scales = array<float>(frame_json()["cells"]["scales"]);
  EXPECT_FLOAT_EQ(scales.at(3 * 4), 1.25F);
  EXPECT_NEAR(scales.at(0) * scales.at(1) * scales.at(2), 1.0F, 1e-5F);  // a shear keeps volumes
}

// The picture's first row is the northern one.
TEST_F(BlenderExport, PicturesOfTheGroundHaveNorthAtTheTop) {
  const glm::vec3 south_west = landscape.ground.at(0, 0) + glm::vec3(0.25F);
  landscape.ground.at(0, 0) = south_west;
  export_frame(landscape, folder / "out");
  const Image ground = read_image(folder / "out/data/frame_0001/ground.exr");
  ASSERT_EQ(ground.height, landscape.ground.samples());
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(ground.pixel(0, ground.height - 1)[channel], south_west[channel], 1e-3F);
}

// Nothing of a finer picture is seen along its edge, all of it in its middle.
TEST_F(BlenderExport, FinerPicturesOfTheGroundFadeInFromTheirEdges) {
  landscape::GroundDetail detail;
  detail.map = ColourMap(41, 0.2, glm::vec3(0.5F));
  landscape.ground_details = {detail};
  export_frame(landscape, folder / "out");
  const Image picture = read_image(folder / "out/data/frame_0001/ground_detail_1.exr");
  ASSERT_EQ(picture.channels, 4);
  constexpr float unseen = 1e-4F;  // B44 rounds
  for (int i = 0; i < 41; ++i) {
    EXPECT_NEAR(picture.pixel(i, 0)[3], 0.0F, unseen);
    EXPECT_NEAR(picture.pixel(0, i)[3], 0.0F, unseen);
    if (i > 0) {
      EXPECT_GE(picture.pixel(std::min(i, 20), 20)[3], picture.pixel(std::min(i, 20) - 1, 20)[3]);
    }
  }
  EXPECT_GT(picture.pixel(20, 20)[3], picture.pixel(1, 20)[3]);
}

// A step is half as long again as a pixel is wide where the volume is nearest.
TEST_F(BlenderExport, StepsFollowTheWidthOfPixels) {
  landscape.volumes.resize(1);
  landscape.cells.resize(1);
  landscape.cells[0].volume = 0;
  landscape.cells[0].world_from_cell = glm::dmat4(1.0);
  constexpr double step_voxels = 2.0;
  const double pixel_m = step_voxels / 1.5 * landscape.volumes[0].voxel_m;
  landscape.width_px = 4000;
  landscape.camera.field_of_view_deg = 90.0;  // half as wide as it is far away
  landscape.camera.eye_m = {0.0, -0.5 * landscape.width_px * pixel_m, 0.0};
  export_frame(landscape, folder / "out");
  EXPECT_NEAR(frame_json()["volumes"][0]["step_voxels"], step_voxels, 0.02 * step_voxels);
}

TEST_F(BlenderExport, VolumesHoldDensityAndItsProductWithLuminance) {
  export_frame(landscape, folder / "out");
  const landscape::Volume& volume = landscape.volumes.front();
  const auto want = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(volume.vdb, "density"));
  const auto radiance =
      openvdb::gridPtrCast<openvdb::Vec3SGrid>(read_vdb_grid(volume.vdb, volume.emission_grid));
  const fs::path file = folder / "out/data/volumes" / (volume.name + ".vdb");
  const auto got = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(file, "density"));
  ASSERT_GT(want->activeVoxelCount(), 100U);
  for (auto at = want->cbeginValueOn(); at; ++at)
    EXPECT_NEAR(density_unit_per_m * got->tree().getValue(at.getCoord()), *at, 1e-3F * *at + 2e-4F);
  const auto emission = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(file, "emission"));
  for (auto at = want->cbeginValueOn(); at; ++at) {
    const openvdb::Vec3s colour = radiance->tree().getValue(at.getCoord());
    const auto gain = static_cast<float>(*at * luminance({colour.x(), colour.y(), colour.z()}));
    EXPECT_NEAR(density_unit_per_m * emission->tree().getValue(at.getCoord()), gain,
                1e-3F * gain + 2e-4F);
  }
  // For Cycles voxel i is the box from i to i + 1: the first one, 1, begins where the cell does.
  EXPECT_LT((got->indexToWorld(openvdb::Coord(1)) - openvdb::Vec3d(0.0)).length(), 1e-9);
  // The box is the volume's and a border of one voxel: what Cycles' seams depend on.
  const openvdb::CoordBBox box = got->evalActiveVoxelBoundingBox();
  EXPECT_EQ(box.min(), openvdb::Coord(0));
  EXPECT_EQ(box.max(),
            openvdb::Coord(volume.voxels.x + 1, volume.voxels.y + 1, volume.voxels.z + 1));
}

// Cycles holds the box of active voxels in memory, all of it.
TEST_F(BlenderExport, VolumesEndAboveTheHighestVoxelThatIsThere) {
  const landscape::Volume& volume = landscape.volumes.front();
  const auto density =
      openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(volume.vdb, "density"));
  const auto radiance = read_vdb_grid(volume.vdb, volume.emission_grid);
  constexpr int highest = 3;
  ASSERT_GT(volume.voxels.z, highest);
  for (auto at = density->beginValueOn(); at; ++at)
    if (at.getCoord().z() > highest) at.setValue(0.0F);
  landscape.volumes.resize(1);
  for (landscape::Cell& cell : landscape.cells) cell.volume = 0;
  write_vdb(volume.vdb, {density, radiance});
  export_frame(landscape, folder / "out");
  const fs::path file = folder / "out/data/volumes" / (volume.name + ".vdb");
  for (const std::string name : {"density", "emission"})
    EXPECT_EQ(read_vdb_grid(file, name)->evalActiveVoxelBoundingBox().max(),
              openvdb::Coord(volume.voxels.x + 1, volume.voxels.y + 1, highest + 1))
        << name;
}

// The synthetic meadow has one colour, at several brightnesses.
TEST_F(BlenderExport, ColoursAreInAPictureBesideTheVolume) {
  export_frame(landscape, folder / "out");
  const auto entry = frame_json()["volumes"][0];
  const landscape::Volume& volume = landscape.volumes.front();
  EXPECT_EQ(entry["colours"]["file"], "../volumes/" + volume.name + ".png");
  EXPECT_EQ(entry["colours"]["side"], volume.voxels.x / 2);
  const fs::path file = folder / "out/data/volumes" / (volume.name + ".png");
  EXPECT_EQ(entry["colours"]["bytes"], fs::file_size(file));
  const Image picture = read_image(file);
  EXPECT_EQ(picture.width, volume.voxels.x / 2 + 2);
  EXPECT_EQ(picture.height, picture.width * entry["colours"]["slices"].get<int>());
  const glm::vec3 own(0.03F, 0.10F, 0.015F);
  const glm::vec3 wanted = own / static_cast<float>(luminance(own));
  const float scale = entry["colours"]["scale"];
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    EXPECT_NEAR(picture.values[i] * scale, wanted[static_cast<int>(i % 3)], 0.6F * scale / 255.0F);
}

TEST_F(BlenderExport, AMissingOrChangedPictureOfColoursIsMadeAnew) {
  export_frame(landscape, folder / "out");
  const fs::path file = folder / "out/data/volumes" / (landscape.volumes[0].name + ".png");
  const std::string whole = read_file(file);
  for (const std::string& damaged : {std::string(), whole.substr(0, whole.size() / 2)}) {
    damaged.empty() ? static_cast<void>(fs::remove(file)) : write_file(file, damaged);
    export_frame(landscape, folder / "out");
    EXPECT_EQ(read_file(file), whole);
  }
}

// A tip with almost no extinction does not make the box higher; one with more does.
TEST_F(BlenderExport, VolumesEndBelowTipsThatHardlyCount) {
  const landscape::Volume& volume = landscape.volumes.front();
  landscape.volumes.resize(1);
  for (landscape::Cell& cell : landscape.cells) cell.volume = 0;
  constexpr int highest = 3;
  constexpr int tip = 6;
  ASSERT_GT(volume.voxels.z, tip);
  const auto radiance = read_vdb_grid(volume.vdb, volume.emission_grid);
  const auto top_with = [&](float tip_fraction) {
    auto density = openvdb::FloatGrid::create(0.0F);
    density->setName("density");
    density->fill({openvdb::Coord(1), openvdb::Coord(10, 10, highest)}, 5.0F);
    density->tree().setValue(openvdb::Coord(4, 4, tip), tip_fraction * 5.0F * 100 * highest);
    write_vdb(volume.vdb, {density, radiance});
    fs::remove_all(folder / "out");
    export_frame(landscape, folder / "out");
    const fs::path file = folder / "out/data/volumes" / (volume.name + ".vdb");
    const auto got = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(file, "density"));
    const openvdb::CoordBBox box = got->evalActiveVoxelBoundingBox();
    for (auto at = got->cbeginValueAll(); at; ++at) {  // the border is of zeros
      if (at.isVoxelValue() && at.getCoord().z() == box.max().z()) {
        EXPECT_EQ(*at, 0.0F);
      }
    }
    return box.max().z() - 1;
  };
  EXPECT_EQ(top_with(0.0004F), highest);
  EXPECT_EQ(top_with(0.0006F), tip);
}

// Cycles makes its hull of the leaves with active voxels, a voxel wider: those of a quarter's hull
// cover what density there is over the quarter and nothing of another one.
TEST_F(BlenderExport, QuartersCoverTheirPartsOfTheVolumeAndNoOther) {
  export_frame(landscape, folder / "out");
  const landscape::Volume& volume = landscape.volumes.front();
  const fs::path file = folder / "out/data/volumes" / (volume.name + ".vdb");
  const auto density = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(file, "density"));
  const auto quarters = landscape::quarters_of_patch(volume.voxels.x);
  for (std::size_t i = 0; i < quarters.size(); ++i) {
    const auto hull = openvdb::gridPtrCast<openvdb::BoolGrid>(
        read_vdb_grid(file, "quarter " + std::to_string(i)));
    openvdb::tools::dilateActiveValues(hull->tree(), 1);
    const auto is_in_hull = [&](const openvdb::Vec3d& voxel) {  // where its middle is, for Cycles
      const openvdb::Vec3d place_m = density->indexToWorld(voxel + openvdb::Vec3d(0.5));
      return hull->tree().probeLeaf(openvdb::Coord::floor(hull->worldToIndex(place_m))) != nullptr;
    };
    for (auto at = density->cbeginValueOn(); at; ++at) {
      EXPECT_LT(*at, 1.0F);
      const openvdb::Vec3d voxel = at.getCoord().asVec3d();
      const glm::dvec2 fraction =
          (glm::dvec2(voxel.x(), voxel.y()) - 0.5) / double(volume.voxels.x);
      const bool inside = glm::all(glm::greaterThan(fraction, quarters[i].low)) &&
                          glm::all(glm::lessThan(fraction, quarters[i].high));
      if (*at > 0.0F) {
        EXPECT_EQ(is_in_hull(voxel), inside) << at.getCoord() << ", quarter " << i;
      }
    }
  }
}

TEST_F(BlenderExport, WritesOnlyVolumesInUseAndTheSameBytesTwice) {
  export_frame(landscape, folder / "out");
  export_frame(landscape, folder / "again");
  EXPECT_FALSE(fs::exists(folder / "out/data/volumes" / (landscape.volumes[2].name + ".vdb")));
  const auto once = all_files(folder / "out");
  EXPECT_EQ(once.size(), 26U);
  EXPECT_TRUE(once == all_files(folder / "again"));
}

TEST_F(BlenderExport, VolumesAreSharedUntilTheirContentChanges) {
  export_frame(landscape, folder / "out");
  const fs::path file = folder / "out/data/volumes" / (landscape.volumes[0].name + ".vdb");
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(file, long_ago);
  landscape.frame = 2;
  export_frame(landscape, folder / "out");
  EXPECT_EQ(fs::last_write_time(file), long_ago);
  landscape.volumes[0].content = "another";
  export_frame(landscape, folder / "out");
  EXPECT_GT(fs::last_write_time(file), long_ago);
}

TEST_F(BlenderExport, MissingVolumeIsAFileError) {
  fs::remove(landscape.volumes[0].vdb);
  EXPECT_THROW(export_frame(landscape, folder / "out"), FileError);
  EXPECT_FALSE(fs::exists(folder / "out/data/frame_0001/frame.json"));
}

TEST_F(BlenderExport, VolumesAndBladesSayWhichLightIsOnThem) {
  landscape.light_details = {ColourMap(5, {glm::dvec2(-3.0), 12.0}, glm::vec3(2.0F))};
  export_frame(landscape, folder / "out");
  const nlohmann::json frame = frame_json();
  EXPECT_EQ(frame.at("format"), 9);  // which older add-ons refuse
  ASSERT_EQ(frame.at("light_details").size(), 1U);
  const nlohmann::json& detail = frame.at("light_details")[0];
  for (const char* name : {"light", "standing_light"}) {
    EXPECT_EQ(detail.at(name).at("samples"), 5) << name;
    EXPECT_EQ(detail.at(name).at("corner_m"), nlohmann::json({-3, -3})) << name;
    EXPECT_TRUE(fs::exists(folder / "out/data/frame_0001" / detail.at(name).at("file"))) << name;
  }
  for (const char* list : {"volumes", "blades"})
    for (const nlohmann::json& entry : frame.at(list)) EXPECT_EQ(entry.at("light_map"), 1) << list;
  landscape.blade_meshes.clear();
  landscape.blade_cells.clear();
  export_frame(landscape, folder / "out");  // light that nothing would show is not written
  EXPECT_FALSE(frame_json().at("light_details")[0].contains("light"));
  EXPECT_FALSE(fs::exists(folder / "out/data/frame_0001/light_1.exr"));
  landscape.light_details.clear();
  export_frame(landscape, folder / "out");
  EXPECT_FALSE(fs::exists(folder / "out/data/frame_0001/standing_light_1.exr"));
  EXPECT_FALSE(fs::exists(folder / "out/data/frame_0001/light_1.exr"));
  EXPECT_EQ(frame_json().at("format"), 7);
}

TEST_F(BlenderExport, BouldersAreArraysWhereThereAreSome) {
  export_frame(landscape, folder / "out");
  EXPECT_FALSE(frame_json().contains("boulders"));
  EXPECT_EQ(frame_json().at("format"), 7);
  landscape.boulders.origin_m = {100, 200, 30};
  landscape.boulders.points_m = {{1, 1, 2}, {0.5F, 0.5F, 1}, {1.5F, 0.5F, 1}, {1, 1.5F, 1}};
  landscape.boulders.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  const std::vector<fs::path> files = export_frame(landscape, folder / "out");
  const nlohmann::json boulders = frame_json().at("boulders");
  EXPECT_EQ(frame_json().at("format"), 8);  // which older add-ons refuse
  EXPECT_EQ(boulders.at("origin_m"), nlohmann::json({100, 200, 30}));
  EXPECT_EQ(boulders.at("point_count"), 4);
  EXPECT_EQ(boulders.at("triangle_count"), 3);
  EXPECT_EQ(array<glm::vec3>(boulders.at("points")), landscape.boulders.points_m);
  EXPECT_EQ(array<glm::uvec3>(boulders.at("triangles")), landscape.boulders.triangles);
  for (const char* kind : {"points", "triangles"})
    EXPECT_TRUE(std::ranges::any_of(files, [&](const fs::path& file) {
      return file.filename() == boulders.at(kind).get<std::string>();
    }));
}

}  // namespace
}  // namespace wold::blender
