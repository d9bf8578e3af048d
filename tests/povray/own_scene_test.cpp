// wold.inc: grass, clouds and snow in a scene of one's own, against scene.pov and closed forms.
#include "povray/own_scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/image.h"
#include "support/cloudy_view.h"
#include "support/constant_meadow.h"
#include "support/penumbra.h"
#include "support/places.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"

namespace wold::povray {
namespace {
namespace fs = std::filesystem;

constexpr double pi = std::numbers::pi;

/// Inverse of the sRGB transfer function (IEC 61966-2-1).
double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

// All macros together, and nothing of one's own, are the landscape's picture, pixel by pixel and
// but for the gaps between cells: with cells, blades, flakes and fog, and with clouds.
TEST_F(OwnScene, MacrosTogetherAreTheScene) {
  landscape::Landscape snowy =
      test::synthetic_landscape({.width_px = 64, .height_px = 36}, folder.path() / "texels");
  landscape::Landscape cloudy = snowy;
  test::add_flakes(snowy, 300, 4.0);
  snowy.fog = landscape::Fog{0.02, glm::vec3(0.1F, 0.11F, 0.12F)};
  test::make_cloudy_view(cloudy);
  cloudy.width_px = 64;
  cloudy.height_px = 36;
  for (const landscape::Landscape& landscape : {snowy, cloudy}) {
    export_all(landscape);
    const Image wanted = run(landscape, folder.path() / "povray/scene.pov");
    const Image picture = run_text(
        landscape,
        "Wold_Light(0) Wold_Ground(0) Wold_Grass(Wold_terrain, 0) Wold_Clouds(0) Wold_Snow(0) "
        "Wold_Camera(0)");
    float largest = 0.0F;
    for (std::size_t i = 0; i < wanted.values.size(); ++i)
      largest = std::max(largest, std::abs(picture.values[i] - wanted.values[i]));
    EXPECT_LE(largest, 1.0F / 255.0F + 1e-6F);
  }
}

/// A meadow of fog, 8/28 m high, seen from far above; the sun stands 45 degrees high in the west.
struct FromAbove {
  test::ConstantMeadow fog;
  double height_m = 8.0 / 28.0;
  landscape::Landscape landscape;

  explicit FromAbove(const fs::path& folder) {
    fog.width_px = 64;
    fog.height_px = 36;
    landscape = test::constant_meadow(fog, folder);
    for (landscape::Cell& cell : landscape.cells) {
      cell.world_from_cell[0].z = 0.0;
      cell.world_from_cell[3].z = 0.0;
    }
    landscape.terrain.values().assign(landscape.terrain.values().size(), 0.0F);
    landscape.daylight = {glm::normalize(glm::dvec3(-1, 0, 1)), glm::vec3(0.8F, 0.6F, 0.4F),
                          glm::vec3(0.2F, 0.3F, 0.5F)};
    landscape.camera = {{1.5, 1.5, 100.0}, {1.5, 1.501, 0.0}, 1.8};
  }

  /// Fraction of the light that goes `depth_m` down into the fog, or as far back up.
  double through(double depth_m) const { return std::exp(-double{fog.extinction} * depth_m); }
  /// What is seen of the fog over something of a radiance, `depth_m` below its top.
  double seen(double depth_m, double below) const {
    return fog.radiance * (1.0 - through(depth_m)) + below * through(depth_m);
  }
  /// Radiance of the picture at a place of the ground on the middle line, x metres from the west.
  double shown(const Image& picture, double x_m, int channel) const {
    const double pixels_per_m = 32.0 / (100.0 * std::tan(0.9 * pi / 180.0));
    const int x = static_cast<int>(32.0 + (x_m - 1.5) * pixels_per_m);
    return linear(picture.pixel(x, 18)[channel]) / landscape.exposure_gain;
  }
};

constexpr const char* one_slab_and_one_block = R"(
  #declare Paint = texture { pigment { rgb 0.25 } finish { ambient 1 diffuse 1 } }
  #declare Things = union {
    box { <0.9, 0.8, 1> * Wold_units_per_m, <1.5, 2.2, 1.02> * Wold_units_per_m }
    box { <0.1, 1.2, -1> * Wold_units_per_m, <0.7, 1.8, 0.1> * Wold_units_per_m }
    texture { Paint }
  }
)";

// A slab hangs over the meadow, a block stands in it with its top 0.1 m above the ground. Light
// follows Lambert's law on them, Beer and Lambert's law down into the grass and up again; in the
// slab's shadow grass and ground have the sky's share alone.
TEST_F(OwnScene, ThingsHideAreHiddenShadeAndAreShaded) {
  const FromAbove view(folder.path() / "texels");
  export_all(view.landscape);
  const std::string things = one_slab_and_one_block;
  const std::string light = "Wold_Light(0) Wold_Ground(0) Wold_Grass(Wold_terrain, 0) ";
  const std::string rest = "Wold_Clouds(0) Wold_Camera(0) object { Things }";
  const Image shaded = run_text(view.landscape, things + "Wold_Shadows(Things) " + light + rest);
  const Image unshaded = run_text(view.landscape, things + light + rest);
  const double sine = std::sqrt(0.5);
  const double depth_m = view.height_m - 0.1;
  const double open = view.seen(view.height_m, view.fog.ground);
  for (int channel = 0; channel < 3; ++channel) {
    SCOPED_TRACE(channel);
    const double sun = sine * view.landscape.daylight.sun_irradiance[channel];
    const double sky = view.landscape.daylight.sky_irradiance[channel];
    const auto expect = [&](const Image& picture, double x_m, double wanted) {
      EXPECT_NEAR(view.shown(picture, x_m, channel), wanted, 0.02 * wanted) << x_m;
    };
    expect(shaded, 1.2, 0.25 / pi * (sun + sky));  // the slab
    const double on_block = 0.25 / pi * (sun * view.through(depth_m / sine) + sky);
    expect(shaded, 0.35, view.seen(depth_m, on_block));
    expect(shaded, 0.56, view.seen(depth_m, on_block));  // lit through the next cell
    expect(shaded, 2.05, open * sky / (sun + sky));      // the slab's shadow, down to the ground
    expect(shaded, 2.75, open);
    expect(unshaded, 2.05, open);
  }
}

// A roof 30 m up hides parts of the sun's disc from 0.28 m on either side of its shadow's edge,
// which is at 2 m: half way a circular segment of 0.1955.
TEST_F(OwnScene, ShadowsAreAsSoftAsTheSun) {
  const FromAbove view(folder.path() / "texels");
  export_all(view.landscape);
  const Image shaded = run_text(
      view.landscape,
      "Wold_Shadows(box { <-40, -8, 30> * Wold_units_per_m, <-28, 12, 30.01> * Wold_units_per_m }) "
      "Wold_Ground(0) Wold_Grass(Wold_terrain, 0) Wold_Clouds(0) Wold_Camera(0)");
  const double open = view.seen(view.height_m, view.fog.ground);
  for (int channel = 0; channel < 3; ++channel) {
    SCOPED_TRACE(channel);
    const double sun = std::sqrt(0.5) * view.landscape.daylight.sun_irradiance[channel];
    const double share = view.landscape.daylight.sky_irradiance[channel] /
                         (sun + view.landscape.daylight.sky_irradiance[channel]);
    const auto hidden = [&](double x_m) {
      return (1.0 - view.shown(shaded, x_m, channel) / open) / (1.0 - share);
    };
    for (const double x_m : {1.426, 1.672, 1.819, 1.966, 2.408})  // middles of pixels
      EXPECT_NEAR(hidden(x_m), test::penumbra(view.fog, view.height_m, x_m - 2.0), 0.1) << x_m;
  }
}

// Lamps add what they send to a place, in the slab's shadow too: of a colour at 10 m twice 1/10 at
// 30 m, as POV-Ray's fade_distance has it, over what sun and sky send to level ground.
TEST_F(OwnScene, LampsLightGrassAndGround) {
  const FromAbove view(folder.path() / "texels");
  export_all(view.landscape);
  const Image lit =
      run_text(view.landscape, std::string(one_slab_and_one_block) +
                                   "Wold_Shadows(Things) "
                                   "Wold_Lamp(<1.5, 1.5, 30> * Wold_units_per_m, <5, 2, 0>, 1000) "
                                   "Wold_Lamp(<2, 1.5, 30> * Wold_units_per_m, <0, 2, 3>, 1000) "
                                   "Wold_Ground(0) Wold_Grass(Wold_terrain, 0) Wold_Camera(0)");
  const double open = view.seen(view.height_m, view.fog.ground);
  const glm::dvec3 colours(5.0, 4.0, 3.0);
  for (int channel = 0; channel < 3; ++channel) {
    SCOPED_TRACE(channel);
    const double sun = std::sqrt(0.5) * view.landscape.daylight.sun_irradiance[channel];
    const double sky = view.landscape.daylight.sky_irradiance[channel];
    const double level = (sun + sky) * view.landscape.exposure_gain / pi;
    const double lamps = colours[channel] * 2.0 / (1.0 + std::pow(29.85 / 10.0, 2.0)) / level;
    EXPECT_NEAR(view.shown(lit, 2.75, channel) / open, 1.0 + lamps, 0.02 * (1.0 + lamps));
    EXPECT_NEAR(view.shown(lit, 2.05, channel) / open, sky / (sun + sky) + lamps, 0.02 * lamps);
  }
}

// Cells are laid on any ground: on a table of a radiance of its own, half a metre up.
TEST_F(OwnScene, GrassStandsOnAGroundOfOnesOwn) {
  FromAbove view(folder.path() / "texels");
  view.landscape.exposure_gain = 1.0;
  export_all(view.landscape);
  const Image picture =
      run_text(view.landscape,
               "#declare Table = box { <-100, -100, 20>, <400, 400, 50> pigment { rgb 0.3 } "
               "finish { ambient 0 diffuse 0 emission 1 } } "
               "object { Table } Wold_Grass(Table, 0) Wold_Camera(0)");
  const double wanted = view.seen(view.height_m, 0.3);
  for (double x_m : {0.6, 1.5, 2.4})
    EXPECT_NEAR(view.shown(picture, x_m, 1), wanted, 0.02 * wanted) << x_m;
}

// The example stands where it stands, on any landscape: a red ball on the ground at 20, 8.2.
TEST_F(OwnScene, ExampleShowsItsBall) {
  FromAbove view(folder.path() / "texels");
  view.landscape.camera = {{20.0, 4.0, 0.6}, {20.0, 8.2, 0.4}, 30.0};
  export_all(view.landscape);
  const Image picture =
      run(view.landscape, wold::test::tests_folder() / ".." / "examples/povray/sphere_and_box.pov");
  EXPECT_GT(picture.pixel(32, 18)[0], 1.5F * picture.pixel(32, 18)[1]);
  EXPECT_LT(picture.pixel(60, 2)[0], 1.1F * picture.pixel(60, 2)[1]);  // the sky
}

// A hut stands at 19.6, 11.5, its roof reddish, and what its eaves do not hide of its walls brown.
TEST_F(OwnScene, ExampleShowsItsHut) {
  FromAbove view(folder.path() / "texels");
  view.landscape.camera = {{22.0, 4.0, 1.2}, {19.6, 11.5, 1.2}, 40.0};
  export_all(view.landscape);
  const Image picture =
      run(view.landscape, wold::test::tests_folder() / ".." / "examples/povray/hut_and_lamp.pov");
  int red = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.pixel(x, y)[0] > 1.5F * picture.pixel(x, y)[1]) ++red;
  EXPECT_GT(red, 100);
}

// Of the frames that have been made the nearest by degree, and of equally near ones by time, gives
// the ground; the nearest by time gives the sky. Three of six have been made.
TEST_F(OwnScene, DegreesAndTimesFindTheirFrames) {
  landscape::Landscape scene = test::constant_meadow({}, folder.path() / "texels");
  scene.cells.clear();
  scene.width_px = 16;
  scene.height_px = 32;
  scene.camera = {{1.5, 0.2, 0.5}, {1.5, 3.0, 0.5}, 60.0};
  for (int frame : {1, 3, 4}) {
    scene.frame = frame;
    scene.weathering = frame == 1 ? 0.0 : 0.8;
    scene.time_s = 60.0 * frame;
    std::fill(scene.ground.values().begin(), scene.ground.values().end(), glm::vec3(0.02F * frame));
    std::fill(scene.sky.values.begin(), scene.sky.values.end(), 0.03F * frame);
    export_all(scene);
  }
  export_scene(std::vector<FrameMoment>{{1, 0.0, 60.0},
                                        {2, 0.4, 120.0},
                                        {3, 0.8, 180.0},
                                        {4, 0.8, 240.0},
                                        {5, 0.41, 300.0},
                                        {6, 0.9, 360.0}},
               folder.path() / "povray");
  const auto expect = [&](const char* text, double ground, double sky) {
    const Image picture = run_text(scene, fmt::format("{} Wold_Camera(0)", text));
    EXPECT_NEAR(linear(picture.pixel(8, 30)[1]) / scene.exposure_gain, ground, 0.002) << text;
    EXPECT_NEAR(linear(picture.pixel(8, 2)[1]) / scene.exposure_gain, sky, 0.002) << text;
  };
  expect("Wold_Ground(0.39) Wold_Clouds(190)", 0.02, 0.09);
  expect("Wold_Ground(0.41) Wold_Clouds(0)", 0.06, 0.03);
  expect("#declare Wold_time_s = 300; Wold_Ground(1) Wold_Clouds(1000)", 0.08, 0.12);
  expect("Wold_Ground(0.9) Wold_Clouds(110)", 0.06, 0.03);
  expect("Wold_Ground(0) Wold_Clouds(290)", 0.02, 0.12);
}

TEST_F(OwnScene, SaysWhatIsMissing) {
  const landscape::Landscape scene = test::constant_meadow({}, folder.path() / "texels");
  const auto said = [&] {
    make_folder(folder.path() / "mine");
    write_file(folder.path() / "mine/my.pov",
               "#version 3.7;\n#include \"wold.inc\"\nWold_Terrain(0)\n");
    const std::string command =
        "cd " + folder.path().string() + "/mine && povray +L../povray my.pov -D > log 2>&1";
    EXPECT_NE(std::system(command.c_str()), 0);
    return read_file(folder.path() / "mine/log");
  };
  export_scene(test::film_of(scene), folder.path() / "povray");
  EXPECT_THAT(said(), testing::HasSubstr("none has been made"));
  fs::remove(folder.path() / "povray/data/frames.inc");
  EXPECT_THAT(said(), testing::HasSubstr("data/frames.inc was not found"));
}

}  // namespace
}  // namespace wold::povray
