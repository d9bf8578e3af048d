// What every exporter owes its caller, whatever the renderer.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"
#include "support/export_all.h"
#include "support/quartered.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"

namespace wold {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

class Exporters : public testing::TestWithParam<const exporter::Exporter*> {
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

  static std::vector<fs::path> run(const Landscape& landscape, const fs::path& folder) {
    return test::export_all(*GetParam(), landscape, folder);
  }

  const fs::path folder =
      fs::path(testing::TempDir()) /
      ("wold_exporters_" + std::string(GetParam()->name) + "_" + std::to_string(::getpid()));
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
    run(landscape, folder / "one");
  }
  run(landscape, folder / "all");
  const auto files = all_files(folder / "one");
  EXPECT_GT(files.size(), 3U);
  EXPECT_TRUE(files == all_files(folder / "all"));
}

TEST_P(Exporters, WritingOverItselfChangesNothing) {
  run(landscape, folder / "out");
  const auto once = all_files(folder / "out");
  run(landscape, folder / "out");
  EXPECT_TRUE(once == all_files(folder / "out"));
}

// What a frame had of flakes, fog and finer pictures of the ground goes when it is written
// again without.
TEST_P(Exporters, WhatAFrameHasNoMoreLeavesNothingInIt) {
  Landscape dry = landscape;
  dry.flakes = {};
  dry.fog.reset();
  dry.ground_details.clear();
  run(dry, folder / "dry");
  run(landscape, folder / "out");
  // Air and finer pictures of the ground are known only with their light.
  const bool shows_air = GetParam()->name != "mitsuba";
  EXPECT_NE(shows_air,
            all_files(folder / "dry/data/frame_0001") == all_files(folder / "out/data/frame_0001"));
  run(dry, folder / "out");
  EXPECT_TRUE(all_files(folder / "dry/data/frame_0001") ==
              all_files(folder / "out/data/frame_0001"));
}

// A file stands where the folder should be: root may write anywhere, so permissions prove nothing.
TEST_P(Exporters, UnwritableFolderIsAFileErrorAndLeavesNothing) {
  fs::create_directories(folder);
  write_file(folder / "blocked", "a file");
  EXPECT_THROW(run(landscape, folder / "blocked"), FileError);
  EXPECT_EQ(read_file(folder / "blocked"), "a file");
  EXPECT_EQ(all_files(folder).size(), 1 + all_files(folder / "texels").size());
}

TEST_P(Exporters, DamagedTexelIsAFileErrorThatNamesIt) {
  const fs::path texel = landscape.volumes[0].vdb;
  fs::resize_file(texel, fs::file_size(texel) / 2);
  try {
    run(landscape, folder / "out");
    FAIL() << "exported a truncated texel";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(texel.filename().string()), std::string::npos)
        << error.what();
  }
}

TEST_P(Exporters, ListTheFilesOfAFrameAndAllOfThemAreThere) {
  const std::vector<fs::path> files = run(landscape, folder / "out");
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) EXPECT_TRUE(fs::is_regular_file(file)) << file;
  for (const std::string& name : GetParam()->files_for_output_folder)
    EXPECT_TRUE(fs::is_regular_file(folder / "out" / name)) << name;
}

// Before it writes, a task looks for links that lead elsewhere in these folders and in no others.
TEST_P(Exporters, WriteToTheFoldersThatTheyName) {
  std::set<fs::path> named = {folder / "out", folder / "out/data/frame_0001"};
  for (const std::string& shared : GetParam()->shared_folders)
    named.insert(folder / "out" / shared);
  run(landscape, folder / "out");
  for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
    EXPECT_TRUE(!entry.is_directory() || named.contains(entry.path())) << entry.path();
}

INSTANTIATE_TEST_SUITE_P(All, Exporters,
                         testing::ValuesIn(film::exporters().begin(), film::exporters().end()),
                         [](const auto& tested) { return std::string(tested.param->name); });

}  // namespace
}  // namespace wold
