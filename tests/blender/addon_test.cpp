// wold_addon.py in Blender itself: addon_check.py uses it as a user would, in the background.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "blender/export.h"
#include "core/files.h"
#include "core/image.h"
#include "support/blurred_difference.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

void expect_done(const std::string& command, const fs::path& log) {
  EXPECT_EQ(std::system(fmt::format("{} > '{}' 2>&1", command, log.string()).c_str()), 0)
      << read_file(log);
}

/// Two frames: the second is withered, has lost its first row of cells and has a darker ground.
void export_film(landscape::Landscape landscape, const fs::path& folder) {
  landscape.weathering = 0.0;
  landscape.daylight = {{-0.6, 0.0, 0.8}, glm::vec3(0.9F, 0.6F, 0.45F), glm::vec3(0.3F)};
  export_frame(landscape, folder);
  landscape.frame = 2;
  landscape.weathering = 0.8;
  landscape.time_s = 60.0;
  landscape.cells.erase(landscape.cells.begin(), landscape.cells.begin() + 6);
  for (glm::vec3& value : landscape.ground.values()) value *= 0.5F;
  export_frame(landscape, folder);
  export_scene(folder);
}

TEST(BlenderAddOn, AddOnImportsAgesAndLeavesCleanly) {
  if (std::system("blender --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "no Blender on this machine: its add-on is not tested";
  const test::TemporaryFolder folder("addon");
  const fs::path& root = folder.path();
  export_film(test::synthetic_landscape({.width_px = 64, .height_px = 36}, root / "texels"),
              root / "blender");
  make_folder(root / "addons");
  const std::string blender = "blender -b --factory-startup --python-exit-code 1 -P";
  expect_done(fmt::format("{} {}/scene.py -- 2 --out {}/scene.png", blender,
                          (root / "blender").string(), root.string()),
              root / "log");
  expect_done(fmt::format("{0} {1}/blender/addon_check.py -- {2}/blender/wold_addon.py {2}/blender "
                          "{2}/addons {2}/addon.png",
                          blender, WOLD_TESTS_DIR, root.string()),
              root / "log");
  ASSERT_TRUE(fs::exists(root / "addon.png")) << read_file(root / "log");
  const double difference =
      test::blurred_difference(read_image(root / "addon.png"), read_image(root / "scene.png"));
  EXPECT_LE(difference, 0.5 / 255.0);
}

}  // namespace
}  // namespace wold::blender
