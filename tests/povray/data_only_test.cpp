#include "povray/data_only.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::povray {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// An exported folder whose files somebody has edited.
class DataOnly : public ::testing::Test {
 protected:
  /// What is said of frame 2, "" when it is data.
  std::string said_of(const std::string& file, const std::string& text) const {
    const fs::path path = folder_.path() / "data" / file;
    make_folder(path.parent_path());
    write_file(path, text);
    std::string said;
    try {
      require_data_only(folder_.path(), 2);
    } catch (const FileError& error) {
      said = error.what();
    }
    fs::remove(path);
    return said;
  }

  test::TemporaryFolder folder_{"data_only"};
};

TEST_F(DataOnly, NumbersNamesAndCommentsAre) {
  EXPECT_EQ(said_of("frame_0002/frame.inc",
                    "#local _version = version;\n#version 3.7;\n// Metres; x east, 1 km: \"far\"\n"
                    "#declare Wold_eye_m = <-0.5, 1e-05, 3.25>;\n"
                    "#declare Wold_terrain_file = \"terrain_3cfc2014cb24781d.inc\";\n"
                    "#declare Wold_boulders_file = \"boulders_3cfc2014cb24781d.inc\";\n"
                    "Wold_grass_density(0, \"v0_k00_062_d\")\n"
                    "Wold_volume(0, \"v0_k00_q0_062\", 0)\n"
                    "Wold_blades(0, \"v0_k01_09e2a5c4_b-2_3_x0-5000_y0-5000\")\n"
                    "#declare Wold_frames = array[1][3] {\n  { 1, 0.1, 0 },\n}\n"
                    "#version _version;"),
            "");
}

// A file that a frame names is included before the boulders' is.
TEST_F(DataOnly, FilesThatNamedFilesNameCount) {
  const auto write = [&](const char* file, const char* text) {
    make_folder((folder_.path() / "data" / file).parent_path());
    write_file(folder_.path() / "data" / file, text);
  };
  write("frame_0002/frame.inc", "#declare Wold_terrain_file = \"terrain_1.inc\";\n");
  write("terrain_1.inc", "#declare Wold_boulders_file = \"other.inc\";\n");
  EXPECT_THAT(said_of("other.inc", "#fopen F \"x\" write"),
              HasSubstr("other.inc:1: found \"#fopen"));
  write("frame_0002/frame.inc", "#declare Wold_boulders_file = \"boulders_1.inc\";\n");
  EXPECT_THAT(said_of("boulders_1.inc", "#fopen F \"x\" write"), HasSubstr("boulders_1.inc"));
  // One that names itself is read once.
  EXPECT_EQ(said_of("boulders_1.inc", "#declare Wold_boulders_file = \"boulders_1.inc\";\n"), "");
}

TEST_F(DataOnly, WhatRunsReadsOrWritesIsNot) {
  for (const char* text : {
           "#fopen F \"x\" write",
           "#  fopen F \"x\" write",
           "#include \"x.inc\"",
           "#macro Wold_volume() #end",
           "#declare Wold_here = \"x\";",          // a name of the program's own
           "#declare Wold_eye_m = concat(\"x\")",  // makes strings
           "#declare Wold_eye_m = 1concat(1)",
           "#declare Wold_eye_m = 1e5concat(1)",
           "Wold_volume(0, chr(47))",
           "Wold_volume(0, \"../x\")",
           "Wold_volume(0, \"/x\")",
           "Wold_volume(0, \"x.inc.pov\")",
           "Wold_volume(0, \"x.pov\")",
           "Wold_volume(0, \"a\n#fopen\")",
           "Wold_volume(0, \"a",
           "// a comment\r#fopen",
           "/* \" */ #fopen",
           "#",
           "\x01",
           "\xc3\xa4",
       })
    EXPECT_THAT(said_of("frame_0002/cells.txt", text), HasSubstr("cells.txt:1: found \"")) << text;
}

TEST_F(DataOnly, IsToldWithLineAndWhatStandsThere) {
  EXPECT_THAT(said_of("blades/v0.inc", "1\n2\n #fopen F \"x\" write\n"),
              HasSubstr("data/blades/v0.inc:3: found \"#fopen F \"x\" write\", expected numbers"));
}

TEST_F(DataOnly, OnlyFilesThatTheFrameCanIncludeCount) {
  const std::string program = "#fopen F \"x\" write";
  EXPECT_EQ(said_of("frame_0001/cells.txt", program), "");
  EXPECT_EQ(said_of("frame_0002/notes.txt", program), "");
  EXPECT_NE(said_of("frames.inc", program), "");
  EXPECT_NE(said_of("volumes/v0.inc", program), "");
}

// The terrain lies among the folders of all frames, which are not looked through.
TEST_F(DataOnly, TheTerrainThatTheFrameNamesCounts) {
  const std::string program = "#fopen F \"x\" write";
  EXPECT_EQ(said_of("terrain_1.inc", program), "");
  make_folder(folder_.path() / "data/frame_0002");
  write_file(folder_.path() / "data/frame_0002/frame.inc",
             "#declare Wold_terrain_file = \"terrain_1.inc\";\n");
  EXPECT_THAT(said_of("terrain_1.inc", program), HasSubstr("data/terrain_1.inc:1: found \""));
  EXPECT_EQ(said_of("terrain_1.inc", "1"), "");
}

// POV-Ray adds endings to a name that has none, and takes the first file that it finds.
TEST_F(DataOnly, TheTerrainsNameIsWhole) {
  for (const char* text :
       {"#declare Wold_terrain_file = \"evil\";", "#declare Wold_terrain_file // ?\n = \"evil\";",
        "#declare Wold_terrain_file=\"x.inc\";", "Wold_terrain_file = \""})
    EXPECT_THAT(said_of("frame_0002/volumes.inc", text), HasSubstr("a file that ends in .inc"))
        << text;
}

TEST_F(DataOnly, FoldersBehindLinksAreRefused) {
  make_folder(folder_.path() / "elsewhere");
  make_folder(folder_.path() / "data");
  fs::create_directory_symlink(folder_.path() / "elsewhere", folder_.path() / "data/volumes");
  EXPECT_THAT(said_of("frames.inc", "1"), HasSubstr("data/volumes: found a link to a folder"));
  fs::remove(folder_.path() / "data/volumes");
  fs::create_directory_symlink(folder_.path() / "elsewhere", folder_.path() / "data/frame_0002");
  EXPECT_THAT(said_of("frames.inc", "1"), HasSubstr("data/frame_0002: found a link to a folder"));
}

}  // namespace
}  // namespace wold::povray
