// What every exporter owes its caller, whatever the renderer.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include "blender/export.h"
#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"
#include "mitsuba/export.h"
#include "povray/export.h"
#include "support/povray_film.h"
#include "support/quartered.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"

namespace wold {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

struct Exporter {
  const char* name;
  std::function<void(const Landscape&, const fs::path& folder)> run;
  bool shows_air = true;  ///< flakes, fog and finer pictures of the ground
};

void export_blender(const Landscape& landscape, const fs::path& folder) {
  blender::export_frame(landscape, folder);
}

void export_povray(const Landscape& landscape, const fs::path& folder) {
  povray::export_frame(landscape, folder);
  povray::export_scene(test::film_of(landscape), folder);
}

void export_mitsuba(const Landscape& landscape, const fs::path& folder) {
  mitsuba::export_frame(landscape, folder);
}

const Exporter exporters[] = {
    {"blender", export_blender},
    {"povray", export_povray},
    {"mitsuba", export_mitsuba, false},
};

class Exporters : public testing::TestWithParam<Exporter> {
 protected:
  Exporters() {
    fs::remove_all(folder);
    landscape =
        test::synthetic_landscape({.cells_per_side = 2, .height_voxels = 8}, folder / "texels");
    test::quarter_cells(landscape);
    test::add_flakes(landscape, 40, 5.0);
    landscape.fog = landscape::Fog{0.01, glm::vec3(0.1F)};
    landscape.ground_details = {{ColourMap(3, 0.5), {0.2, 0.3}}, {ColourMap(3, 0.2), {0.3, 0.4}}};
  }
  ~Exporters() override { fs::remove_all(folder); }

  const fs::path folder =
      fs::path(testing::TempDir()) /
      ("wold_exporters_" + std::string(GetParam().name) + "_" + std::to_string(::getpid()));
  Landscape landscape;
};

std::map<std::string, std::string> all_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder)] = read_file(entry.path());
  return files;
}

TEST_P(Exporters, SameLandscapeGivesTheSameBytesWithAnyNumberOfThreads) {
  {
    const ThreadLimit one(1);
    GetParam().run(landscape, folder / "one");
  }
  GetParam().run(landscape, folder / "all");
  const auto files = all_files(folder / "one");
  EXPECT_GT(files.size(), 3U);
  EXPECT_TRUE(files == all_files(folder / "all"));
}

TEST_P(Exporters, WritingOverItselfChangesNothing) {
  GetParam().run(landscape, folder / "out");
  const auto once = all_files(folder / "out");
  GetParam().run(landscape, folder / "out");
  EXPECT_TRUE(once == all_files(folder / "out"));
}

// What a frame had of flakes, fog and finer pictures of the ground goes when it is written
// again without.
TEST_P(Exporters, WhatAFrameHasNoMoreLeavesNothingInIt) {
  Landscape dry = landscape;
  dry.flakes = {};
  dry.fog.reset();
  dry.ground_details.clear();
  GetParam().run(dry, folder / "dry");
  GetParam().run(landscape, folder / "out");
  EXPECT_NE(GetParam().shows_air,
            all_files(folder / "dry/data/frame_0001") == all_files(folder / "out/data/frame_0001"));
  GetParam().run(dry, folder / "out");
  EXPECT_TRUE(all_files(folder / "dry/data/frame_0001") ==
              all_files(folder / "out/data/frame_0001"));
}

// A file stands where the folder should be: root may write anywhere, so permissions prove nothing.
TEST_P(Exporters, UnwritableFolderIsAFileErrorAndLeavesNothing) {
  fs::create_directories(folder);
  write_file(folder / "blocked", "a file");
  EXPECT_THROW(GetParam().run(landscape, folder / "blocked"), FileError);
  EXPECT_EQ(read_file(folder / "blocked"), "a file");
  EXPECT_EQ(all_files(folder).size(), 1 + all_files(folder / "texels").size());
}

TEST_P(Exporters, DamagedTexelIsAFileErrorThatNamesIt) {
  const fs::path texel = landscape.volumes[0].vdb;
  fs::resize_file(texel, fs::file_size(texel) / 2);
  try {
    GetParam().run(landscape, folder / "out");
    FAIL() << "exported a truncated texel";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(texel.filename().string()), std::string::npos)
        << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(All, Exporters, testing::ValuesIn(exporters),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace wold
