// The add-on in Blender itself: addon_check.py uses it as a user would, in the background.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "blender/export.h"
#include "core/files.h"
#include "core/image.h"
#include "support/blender.h"
#include "support/blurred_difference.h"
#include "support/places.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

void expect_done(const std::string& command, const fs::path& log) {
  EXPECT_EQ(std::system(fmt::format("{} > '{}' 2>&1", command, log.string()).c_str()), 0)
      << read_file(log);
}

/// Blender keeps what a user installs below these.
std::string clean_profile(const fs::path& root) {
  return fmt::format(
      "env BLENDER_USER_RESOURCES={0}/profile BLENDER_USER_SCRIPTS={0}/profile "
      "BLENDER_USER_CONFIG={0}/profile BLENDER_USER_EXTENSIONS={0}/profile",
      root.string());
}

/// Two frames: the second is withered, has lost its first row of cells, has a darker ground and is
/// seen from a metre farther off.
void export_film(landscape::Landscape landscape, const fs::path& folder) {
  landscape.weathering = 0.0;
  landscape.daylight = {{-0.6, 0.0, 0.8}, glm::vec3(0.9F, 0.6F, 0.45F), glm::vec3(0.3F)};
  export_frame(landscape, folder);
  landscape.frame = 2;
  landscape.weathering = 0.8;
  landscape.time_s = 60.0;
  landscape.cells.erase(landscape.cells.begin(), landscape.cells.begin() + 6);
  for (glm::vec3& value : landscape.ground.values()) value *= 0.5F;
  landscape.camera.eye_m.y -= 1.0;
  export_frame(landscape, folder);
}

TEST(BlenderAddOn, IsInstalledFollowsTheTimelineAndLeavesCleanly) {
  if (!test::has_blender()) GTEST_SKIP() << "no Blender on this machine: its add-on is not tested";
  const test::TemporaryFolder folder("addon");
  const fs::path& root = folder.path();
  export_film(test::synthetic_landscape({.width_px = 64, .height_px = 36}, root / "texels"),
              root / "blender");
  const fs::path log = root / "log";
  expect_done(fmt::format("{} extension --out {}", test::wold_program().string(), root.string()),
              log);
  expect_done(fmt::format("{} --out {}/alone.png", test::blender_render(root / "blender", 2),
                          root.string()),
              log);
  expect_done(fmt::format("{0} {1} -- {2}/wold_blender-*.zip {2}/blender {2}/addon.png",
                          clean_profile(root),
                          test::blender_script(test::tests_folder() / "blender/addon_check.py"),
                          root.string()),
              log);
  ASSERT_TRUE(fs::exists(root / "addon.png")) << read_file(root / "log");
  const double difference =
      test::blurred_difference(read_image(root / "addon.png"), read_image(root / "alone.png"));
  EXPECT_LE(difference, 0.5 / 255.0);
}

}  // namespace
}  // namespace wold::blender
