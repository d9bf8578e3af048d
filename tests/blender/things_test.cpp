// The user's own things in Blender: the shadow that they throw on grass and ground, and lamps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "blender/export.h"
#include "core/files.h"
#include "core/image.h"
#include "support/blender.h"
#include "support/constant_meadow.h"
#include "support/penumbra.h"
#include "support/places.h"
#include "support/temporary_folder.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;
constexpr double pi = std::numbers::pi;

/// A meadow of fog, seen from far above; the sun stands 45 degrees high in the west. In the second
/// frame clouds leave half of the light of the sky.
struct LitMeadow {
  glm::vec3 sun{0.8F, 0.6F, 0.4F};
  glm::vec3 sky{0.2F, 0.3F, 0.5F};
  test::ConstantMeadow fog{.width_px = 64, .height_px = 36};
  double height_m = 8.0 / 28.0;

  glm::vec3 level() const { return sky + sun * float(std::sqrt(0.5)); }

  void export_frames(const fs::path& folder) const {
    landscape::Landscape landscape = test::constant_meadow(fog, folder / "texels");
    for (landscape::Cell& cell : landscape.cells) {
      cell.world_from_cell[0].z = 0.0;
      cell.world_from_cell[3].z = 0.0;
    }
    landscape.blade_cells.clear();  // nothing but what is made of things reads the map of light
    landscape.blade_meshes.clear();
    landscape.terrain.values().assign(landscape.terrain.values().size(), 0.0F);
    landscape.daylight = {glm::normalize(glm::dvec3(-1, 0, 1)), sun, sky};
    landscape.camera = {{1.5, 1.5, 100.0}, {1.5, 1.501, 0.0}, 1.8};
    export_frame(landscape, folder / "blender");
    landscape.frame = 2;
    for (glm::vec3& light : landscape.light.values()) light = 0.5F * sky / level();
    export_frame(landscape, folder / "blender");
  }
};

/// Radiance at a place of the ground on the middle line, x metres from the west.
double shown(const fs::path& picture, double x_m, int channel) {
  const double pixels_per_m = 32.0 / (100.0 * std::tan(0.9 * pi / 180.0));
  const int x = static_cast<int>(32.0 + (x_m - 1.5) * pixels_per_m);
  return read_image(picture).pixel(x, 18)[channel];
}

// A slab hangs a metre above the meadow: its shadow lies a metre to the east, and there grass and
// ground have the sky's share alone. It moves when the slab does. One 30 m up
// hides parts of the sun's disc. Where clouds have taken the sun already, nothing more is taken. A
// lamp adds what its irradiance is over that of sun and sky.
TEST(BlenderAddOn, ThingsShadeAndLampsLightTheMeadow) {
  if (!test::has_blender()) GTEST_SKIP() << "no Blender on this machine: shadows are not tested";
  const test::TemporaryFolder folder("things");
  const fs::path& root = folder.path();
  const LitMeadow meadow;
  meadow.export_frames(root);
  const std::string command =
      fmt::format("{} -- '{}' '{}' '{}' > '{}' 2>&1",
                  test::blender_script(test::tests_folder() / "blender/things_check.py"),
                  (test::templates_folder() / "blender").string(), (root / "blender").string(),
                  root.string(), (root / "log").string());
  ASSERT_EQ(std::system(command.c_str()), 0) << read_file(root / "log");
  EXPECT_TRUE(fs::exists(root / "hut.png"));
  for (int channel = 0; channel < 3; ++channel) {
    SCOPED_TRACE(channel);
    const auto ratio = [&](const char* picture, const char* other, double x_m) {
      return shown(root / fmt::format("{}.exr", picture), x_m, channel) /
             shown(root / fmt::format("{}.exr", other), x_m, channel);
    };
    const double share = meadow.sky[channel] / meadow.level()[channel];
    EXPECT_NEAR(ratio("shaded", "open", 2.2), share, 0.01 * share);
    for (const double x_m : {0.5, 1.2, 2.8})
      EXPECT_NEAR(ratio("shaded", "open", x_m), 1.0, 0.002) << x_m;
    EXPECT_NEAR(ratio("moved", "open", 1.7), share, 0.01 * share);
    EXPECT_NEAR(ratio("moved", "open", 2.4), 1.0, 0.002);
    const auto hidden = [&](double x_m) {
      return (1.0 - ratio("high", "open", x_m)) / (1.0 - share);
    };
    for (const double x_m : {1.426, 1.672, 1.819, 1.966, 2.408})  // middles of pixels
      EXPECT_NEAR(hidden(x_m), test::penumbra(meadow.fog, meadow.height_m, x_m - 2.0), 0.06) << x_m;
    EXPECT_NEAR(ratio("cloudy", "cloudy_open", 1.7), 1.0, 0.002);
    const double lamp = 20000.0 / (4.0 * pi * 29.8 * 29.8) * std::pow(0.5, channel);
    const double lit = 1.0 + lamp / (0.5 * meadow.sky[channel]);
    EXPECT_NEAR(ratio("lamp", "cloudy_open", 1.5), lit, 0.01 * lit);
  }
}

}  // namespace
}  // namespace wold::blender
