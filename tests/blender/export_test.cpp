#include "blender/export.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
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
  ASSERT_EQ(positions_m.size(), 3 * landscape.cells.size());
  for (std::size_t i = 0; i < landscape.cells.size(); ++i) {
    const landscape::Cell& cell = landscape.cells[i];
    const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
    const auto pick = static_cast<std::size_t>(picks.at(i));
    EXPECT_EQ(frame["volumes"][pick]["file"],
              "../volumes/" + volume.name + suffix_of(cell.part) + ".vdb");
    for (int axis = 0; axis < 3; ++axis)  // nudged by at most 0.03 voxels
      EXPECT_NEAR(positions_m[3 * i + static_cast<std::size_t>(axis)],
                  cell.world_from_cell[3][axis], 0.031 * volume.voxel_m);
  }
}

TEST_F(BlenderExport, VolumesHoldDensityAndItsProductWithRadiance) {
  export_frame(landscape, folder / "out");
  const landscape::Volume& volume = landscape.volumes.front();
  const auto want = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(volume.vdb, "density"));
  const auto radiance =
      openvdb::gridPtrCast<openvdb::Vec3SGrid>(read_vdb_grid(volume.vdb, volume.emission_grid));
  const fs::path file = folder / "out/data/volumes" / (volume.name + ".vdb");
  const auto got = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(file, "density"));
  const auto emission = openvdb::gridPtrCast<openvdb::Vec3SGrid>(read_vdb_grid(file, "emission"));
  ASSERT_GT(want->activeVoxelCount(), 100U);
  for (auto at = want->cbeginValueOn(); at; ++at) {
    const float rho = got->tree().getValue(at.getCoord());
    const openvdb::Vec3s light = *at * radiance->tree().getValue(at.getCoord());
    EXPECT_NEAR(rho, *at, 1e-3F * *at);
    EXPECT_LT((emission->tree().getValue(at.getCoord()) - light).length(), 1e-3F * light.length());
  }
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

// Cycles interpolates linearly and each part fades within its border, so what counts is the sum.
TEST_F(BlenderExport, PartsOfAVolumeAddUpToIt) {
  landscape.volumes.resize(1);
  landscape.cells.resize(2);
  for (landscape::Cell& cell : landscape.cells) cell.volume = 0;
  test::quarter_cells(landscape);
  export_frame(landscape, folder / "out");
  const landscape::Volume& volume = landscape.volumes.front();
  const auto density_of = [&](const landscape::Part& part) {
    return openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(
        folder / "out/data/volumes" / (volume.name + suffix_of(part) + ".vdb"), "density"));
  };
  auto left = density_of({});
  std::size_t voxels = 0;
  for (const landscape::Part& part : landscape::quarters_of_patch(volume.voxels.x)) {
    const auto density = density_of(part);
    EXPECT_EQ(density->transform(), left->transform());
    const openvdb::CoordBBox box = density->evalActiveVoxelBoundingBox();
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(box.min()[axis], part.low[axis] * volume.voxels.x, 1e-9);
      EXPECT_NEAR(box.max()[axis], part.high[axis] * volume.voxels.x + 1.0, 1e-9);
    }
    EXPECT_EQ(box.min().z(), 0);
    EXPECT_EQ(box.max().z(), volume.voxels.z + 1);
    for (auto at = density->cbeginValueOn(); at; ++at) {
      const float before = left->tree().getValue(at.getCoord());
      if (*at > 0.0F) {
        ++voxels;
        EXPECT_EQ(*at, before) << "shown by two parts, or by another than the whole";
        left->tree().setValue(at.getCoord(), 0.0F);
      }
    }
  }
  EXPECT_GT(voxels, 100U);
  for (auto at = left->cbeginValueOn(); at; ++at) EXPECT_EQ(*at, 0.0F) << at.getCoord();
}

TEST_F(BlenderExport, WritesOnlyVolumesInUseAndTheSameBytesTwice) {
  export_frame(landscape, folder / "out");
  export_scene(folder / "out");
  export_frame(landscape, folder / "again");
  export_scene(folder / "again");
  EXPECT_FALSE(fs::exists(folder / "out/data/volumes" / (landscape.volumes[2].name + ".vdb")));
  const auto once = all_files(folder / "out");
  EXPECT_EQ(once.size(), 23U);
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

}  // namespace
}  // namespace wold::blender
