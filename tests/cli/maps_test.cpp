#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "program.h"

namespace wold::test {
namespace {

using testing::HasSubstr;

// Five heights along each side, 12 m apart, in a file that is called as a map is.
constexpr const char* model =
    "ncols 5\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 12\n"
    "1 2 3 4 5\n1 2 3 4 5\n1 2 3 4 5\n1 2 3 4 5\n1 2 3 4 5\n";
constexpr const char* scene = "[terrain]\nelevation = \"height.tif\"\nsamples = 33\n";

TEST_F(Program, MapsLeaveTheElevationModelAsItIs) {
  write("height.tif", model);
  write("a.toml", scene);
  const Result refused = wold("maps a.toml --out .");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("height.tif, which is read, too, and would be lost"));
  EXPECT_EQ(read_file(folder_ / "height.tif"), model);
  EXPECT_FALSE(fs::exists(folder_ / "slope.tif"));
  EXPECT_EQ(wold("maps a.toml --quiet --out maps --frames 1").code, 0);
}

TEST_F(Program, MapsThatAreThereStayUntilTheSceneChanges) {
  write("height.tif", model);
  write("a.toml", scene);
  const fs::path map = folder_ / "maps" / "weathering_0001.tif";
  EXPECT_EQ(wold("maps a.toml --quiet --out maps --frames 1").code, 0);
  const fs::file_time_type long_ago{};
  fs::last_write_time(map, long_ago);
  EXPECT_EQ(wold("maps a.toml --quiet --out maps --frames 1-2 --set render.threads=1").code, 0);
  EXPECT_EQ(fs::last_write_time(map), long_ago);
  EXPECT_TRUE(fs::exists(folder_ / "maps" / "weathering_0002.tif"));
  EXPECT_EQ(wold("maps a.toml --quiet --out maps --frames 1 --set seed=77").code, 0);
  EXPECT_NE(fs::last_write_time(map), long_ago);
}

TEST_F(Program, MapsAreOfFramesThatTheSceneHas) {
  write("height.tif", model);
  write("a.toml", scene);
  const Result refused = wold("maps a.toml --out maps --frames 4");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--frames: found 4, expected frames from 1 to 3"));
  EXPECT_FALSE(fs::exists(folder_ / "maps"));
}

}  // namespace
}  // namespace wold::test
