#include "compare/vdb.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vdb.h"
#include "scratch_folder.h"
#include "vdb_samples.h"

namespace wold::compare {
namespace {

using test::SampleVdb;

VdbMetrics compared(const SampleVdb& got, const SampleVdb& want) {
  const test::ScratchFolder folder;
  test::write_sample_vdb(folder / "got.vdb", got);
  test::write_sample_vdb(folder / "want.vdb", want);
  return compare_vdb(folder / "got.vdb", folder / "want.vdb", 0.02);
}

TEST(CompareVdb, EqualFiles) {
  const VdbMetrics metrics = compared({}, {});
  ASSERT_EQ(metrics.grids.size(), 2U);
  for (const GridMetrics& grid : metrics.grids) {
    EXPECT_TRUE(grid.is_compared && grid.same_type && grid.same_transform);
    EXPECT_EQ(grid.max_error, 0.0);
    EXPECT_EQ(grid.want.active_voxels, 512U);
  }
}

// Blender's hulls are grids of truth values.
TEST(CompareVdb, GridsOfTruthValues) {
  const test::ScratchFolder folder;
  const auto write = [&](const char* name, bool second) {
    const openvdb::BoolGrid::Ptr grid = openvdb::BoolGrid::create(false);
    grid->setName("quarter 0");
    grid->tree().setValueOn({0, 0, 0}, true);
    grid->tree().setValueOn({1, 0, 0}, second);
    openvdb::io::File((folder / name).string()).write({grid});
  };
  openvdb::initialize();
  write("got.vdb", true);
  write("same.vdb", true);
  write("want.vdb", false);
  const GridMetrics same = compare_vdb(folder / "got.vdb", folder / "same.vdb", 0.02).grids.front();
  EXPECT_TRUE(same.is_compared);
  EXPECT_EQ(same.max_error, 0.0);
  EXPECT_EQ(compare_vdb(folder / "got.vdb", folder / "want.vdb", 0.02).grids.front().max_error,
            1.0);
}

TEST(CompareVdb, OneVoxelOffIsRelativeToTheLargestValue) {
  const VdbMetrics metrics = compared({.changed = 0.5F}, {});
  const GridMetrics& density = metrics.grids.front();
  EXPECT_NEAR(density.max_error, 0.25, 1e-7);
  EXPECT_DOUBLE_EQ(density.fraction_over_soft, 1.0 / 512.0);
  EXPECT_NEAR(density.rmse, 0.25 / std::sqrt(512.0), 1e-7);
}

TEST(CompareVdb, AVoxelActiveInOneFileCounts) {
  for (const bool in_got : {true, false}) {
    const SampleVdb more{.extra_voxel = 1};
    const GridMetrics grid =
        compared(in_got ? more : SampleVdb{}, in_got ? SampleVdb{} : more).grids[0];
    EXPECT_DOUBLE_EQ(grid.max_error, 1.0);
    EXPECT_DOUBLE_EQ(grid.fraction_over_soft, 1.0 / 513.0);
    EXPECT_EQ((in_got ? grid.got : grid.want).box_max, glm::ivec3(20, 7, 7));
  }
}

TEST(CompareVdb, CountsVoxelsActiveInOneEvenWhenTheirValuesAgree) {
  const GridMetrics grid =
      compared({.extra_voxel = 1, .active_zeros = 3}, {.active_zeros = 5}).grids.front();
  EXPECT_EQ(grid.active_only_got, 1U);
  EXPECT_EQ(grid.active_only_want, 2U);
  EXPECT_DOUBLE_EQ(grid.fraction_active_in_one, 3.0 / 518.0);
  EXPECT_DOUBLE_EQ(grid.fraction_over_soft, 1.0 / 518.0);
}

TEST(CompareVdb, MissingGridsAndOtherTransforms) {
  const VdbMetrics metrics = compared({.voxel_m = 0.5, .has_emission = false}, {});
  EXPECT_FALSE(metrics.grids.front().same_transform);
  EXPECT_EQ(metrics.only_want, std::vector<std::string>{"emission"});
  EXPECT_TRUE(metrics.only_got.empty());
}

TEST(VdbFacts, AreThoseOfTheGrids) {
  const test::ScratchFolder folder;
  test::write_sample_vdb(folder / "a.vdb", {.peak = 3.0F});
  const GridFacts density = vdb_facts(folder / "a.vdb").grids.at(0);
  EXPECT_EQ(density.name, "density");
  EXPECT_EQ(density.box_max, glm::ivec3(7));
  EXPECT_EQ(density.voxel_m, glm::dvec3(0.25));
  EXPECT_DOUBLE_EQ(density.min, 0.0);
  EXPECT_DOUBLE_EQ(density.largest, 3.0);
  EXPECT_EQ(density.non_finite, 0U);
}

}  // namespace
}  // namespace wold::compare
