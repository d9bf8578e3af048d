#include "film/machine_check.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/files.h"
#include "scene/parse.h"
#include "support/temporary_folder.h"

namespace wold::film {
namespace {

using Messages = std::vector<std::string>;
using Check = void (*)(const scene::Scene&, const scene::Places&);

/// What a check says of a scene file "a.toml" of that text, which reads without a problem.
Messages said(Check check, const std::string& text, const Messages& overrides = {}) {
  const auto [scene, places, warnings] = scene::parse_located_scene(text, "a.toml", overrides);
  Messages messages;
  try {
    check(scene, places);
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) messages.push_back(to_string(problem));
  }
  return messages;
}

TEST(RequireFiles, BlamesTheKeyOfEachFileThatIsNotThere) {
  EXPECT_EQ(said(require_files,
                 "[[clouds]]\ntextures = ['/none.png']\n[terrain]\nelevation = '/none.tif'\n"
                 "[season]\nfirst = [2026, 9, 1]\nlast = [2026, 11, 1]\ntable = '/none.csv'\n"),
            (Messages{"a.toml:2:1: clouds[1].textures: found \"/none.png\", expected a file that "
                      "is there",
                      "a.toml:4:1: terrain.elevation: found \"/none.tif\", expected a file that is "
                      "there",
                      "a.toml:8:1: season.table: found \"/none.csv\", expected a file that is "
                      "there"}));
}

TEST(RequireFiles, LooksAtOverridesAndRefusesFolders) {
  for (const std::string key : {"growth.mask", "grass.from_texel", "weather.table"}) {
    const std::string text = key + "=\"/dev\"";
    const Messages messages = said(require_files, "", {text});
    ASSERT_EQ(messages.size(), 1U) << key;
    EXPECT_EQ(messages[0],
              "--set " + text + ": " + key + ": found \"/dev\", expected a file that is there");
  }
}

TEST(RequireFiles, LooksAtMasksOfSpecies) {
  EXPECT_EQ(said(require_files, "[[species]]\n[[species]]\nmask = '/none.png'\n"),
            Messages{"a.toml:3:1: species[2].mask: found \"/none.png\", expected a file that is "
                     "there"});
}

TEST(RequireFiles, IsContentWithFilesThatAreThere) {
  const test::TemporaryFolder folder("machine_check");
  const std::string file = (folder.path() / "a.png").string();
  write_file(file, "a picture");
  EXPECT_EQ(said(require_files, ""), Messages{});
  EXPECT_EQ(said(require_files, "[growth]\nmask = '" + file + "'\n"), Messages{});
}

TEST(RequireTexelMemory, RefusesMorePointsThanTheMachineHolds) {
  EXPECT_EQ(said(require_texel_memory, ""), Messages{});
  // Points of a hundred gigabytes for each of the patches that are made at once.
  const Messages messages =
      said(require_texel_memory,
           "[grass]\nblades = 20000\npoints_per_voxel_face = 1000\nvariants = 64\n"
           "[render]\nthreads = 64\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(messages[0].starts_with(
      "a.toml:3:1: grass.levels: found 254 voxels along a side and 2.5e+09 points in a patch, "
      "which for 64 patches at once need "))
      << messages[0];
}

}  // namespace
}  // namespace wold::film
