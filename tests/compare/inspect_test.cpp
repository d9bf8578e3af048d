#include "compare/inspect.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/layered_image.h"
#include "scratch_folder.h"
#include "vdb_samples.h"

namespace wold::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Inspect : public ::testing::Test {
 protected:
  test::ScratchFolder folder_;
};

TEST_F(Inspect, ASoundDf3) {
  write_file(folder_ / "a.df3", std::string_view("\0\2\0\1\0\3\0\63\146\231\314\377", 12));
  const Inspection result = inspect(folder_ / "a.df3");
  EXPECT_THAT(result.problems, IsEmpty());
  EXPECT_THAT(result.text,
              HasSubstr("kind: df3\nbytes: 12\nsize: [2,1,3]\nbits: 8\nrange: [0.0,1.0]"));
}

TEST_F(Inspect, ATruncatedDf3ReportsTheLengths) {
  write_file(folder_ / "a.df3", std::string_view("\0\2\0\1\0\3\0\63\146", 9));
  EXPECT_THAT(inspect(folder_ / "a.df3").problems,
              ElementsAre(HasSubstr("2 x 1 x 3, so 6, 12 or 24 bytes of values (8, 16 or 32 bit) "
                                    "were expected, 3 found")));
}

TEST_F(Inspect, GridsOfAVdb) {
  test::write_sample_vdb(folder_ / "a.vdb", {.peak = 3.0F});
  const Inspection result = inspect(folder_ / "a.vdb");
  EXPECT_THAT(result.problems, IsEmpty());
  EXPECT_THAT(result.text, HasSubstr("box_max: [7,7,7]\n    voxel_m: [0.25,0.25,0.25]\n"
                                     "    active_voxels: 512\n    range: [0.0,3.0]"));
}

TEST_F(Inspect, GridProblems) {
  test::write_sample_vdb(folder_ / "a.vdb", {.changed = std::nanf(""), .has_emission = false});
  EXPECT_THAT(inspect(folder_ / "a.vdb").problems,
              ElementsAre("grid density: 1 values are no finite numbers"));
}

TEST_F(Inspect, PictureProblems) {
  Image image(4, 2, 3);
  write_image(folder_ / "blank.png", image, PixelFormat::uint8);
  EXPECT_THAT(inspect(folder_ / "blank.png").problems, ElementsAre(HasSubstr("blank")));
  image.values[0] = 1.0F / 255.0F;
  write_image(folder_ / "dithered.png", image, PixelFormat::uint8);
  EXPECT_THAT(inspect(folder_ / "dithered.png").problems, ElementsAre(HasSubstr("blank")));
  image.values[0] = 2.0F / 255.0F;
  write_image(folder_ / "dark.png", image, PixelFormat::uint8);
  EXPECT_THAT(inspect(folder_ / "dark.png").problems, ElementsAre());
  image.values = std::vector<float>(24, 0.5F);
  image.values[0] = std::nanf("");
  image.values[1] = 1.0F;
  write_image(folder_ / "nan.exr", image, PixelFormat::float32);
  const Inspection result = inspect(folder_ / "nan.exr");
  EXPECT_THAT(result.problems, ElementsAre("1 values are no finite numbers"));
  EXPECT_THAT(result.json, HasSubstr("\"stored_as\": \"float\""));
}

TEST_F(Inspect, LayersAreListedWithWhatTheHeaderSaysOfThem) {
  write_layered_image(
      folder_ / "layers.exr",
      {2,
       1,
       {{"depth.Z", PixelFormat::float32, {3.5F, 1e10F}},
        {"kind00.R", PixelFormat::float32, {std::bit_cast<float>(0x248bfa47U), 0.0F}},
        {"kind00.G", PixelFormat::float32, {0.5F, 0.0F}}},
       {{"wold/depth", "m; along the camera's axis"},
        {"cryptomatte/1234567/name", "kind"},
        {"cryptomatte/1234567/manifest", R"({"hello":"248bfa47","bad":7,"worse":"x"})"}}});
  const auto facts = nlohmann::json::parse(inspect(folder_ / "layers.exr").json);
  const auto& depth = facts.at("layers").at("depth");
  EXPECT_EQ(depth.at("unit"), "m");
  EXPECT_EQ(depth.at("meaning"), "along the camera's axis");
  EXPECT_THAT(depth.at("channels").at("depth.Z").at("range"), ElementsAre(3.5, 3.5));
  EXPECT_EQ(depth.at("channels").at("depth.Z").at("fraction_without_a_number"), 0.5);
  const auto& names = facts.at("layers").at("kind").at("covered_by");
  EXPECT_EQ(names.size(), 1U);
  EXPECT_EQ(names.at("hello"), 0.25);
}

TEST_F(Inspect, DamageIsAProblemAndAbsenceAnError) {
  write_file(folder_ / "a.vdb", "not a grid");
  write_file(folder_ / "a.png", "not a picture");
  EXPECT_EQ(inspect(folder_ / "a.vdb").problems.size(), 1U);
  EXPECT_EQ(inspect(folder_ / "a.png").problems.size(), 1U);
  EXPECT_THROW(inspect(folder_ / "none.df3"), FileError);
}

}  // namespace
}  // namespace wold::compare
