// What Mitsuba makes of the files, against closed forms. Skipped where WOLD_MITSUBA, a Python, or
// else python3 has no package mitsuba.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/files.h"
#include "core/image.h"
#include "core/random.h"
#include "mitsuba/export.h"
#include "support/constant_meadow.h"
#include "support/temporary_folder.h"

namespace wold::mitsuba {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

constexpr double pi = std::numbers::pi;

std::string python() {
  const char* chosen = std::getenv("WOLD_MITSUBA");
  return chosen != nullptr ? chosen : "python3";
}

class MitsubaLight : public testing::Test {
 protected:
  void SetUp() override {
    const std::string probe = python() + " -c 'import mitsuba' > /dev/null 2>&1";
    if (std::system(probe.c_str()) != 0)
      GTEST_SKIP() << python() << " has no package mitsuba: its light is not compared";
  }

  /// An empty, level world of 4 x 4 m: black ground at -2 m, no light, seen from 1 m below 0.
  static Landscape dark() {
    Landscape dark;
    dark.terrain = Heightfield(5, 4.0, -2.0F);
    dark.extinction_factor = FactorMap(2, 4.0, 1.0F);
    dark.patch_m = 0.5;
    dark.unlit =
        landscape::Unlit{glm::vec3(0.0F), Image(32, 16, 3), ColourMap(5, 4.0, glm::vec3(0.0F))};
    set_sky(dark, 1e-6F);  // Mitsuba refuses a sky that is black
    dark.camera = {{2.0, 2.0, -1.0}, {2.0, 2.001, 0.0}, 30.0};
    dark.width_px = 24;
    dark.height_px = 16;
    dark.exposure_gain = 1.0;
    return dark;
  }

  static void set_sky(Landscape& landscape, float radiance) {
    std::fill(landscape.unlit->sky.values.begin(), landscape.unlit->sky.values.end(), radiance);
  }

  Image render(const Landscape& landscape, int samples) const {
    export_frame(landscape, folder_.path());
    const std::string command = fmt::format(
        "cd '{0}' && {1} -B '{2}' data/frame_0001/scene.xml --variant scalar_rgb "
        "--samples {3} --out picture.exr > log 2>&1",
        folder_.path().string(), python(), shipped_file("templates/mitsuba/render.py").string(),
        samples);
    if (std::system(command.c_str()) != 0) {
      ADD_FAILURE() << read_file(folder_.path() / "log");
      return Image(landscape.width_px, landscape.height_px, 3);
    }
    return read_image(folder_.path() / "picture.exr");
  }

  static double mean(const Image& picture, int channel) {
    double sum = 0.0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) sum += double{picture.pixel(x, y)[channel]};
    return sum / (picture.width * picture.height);
  }

  const test::TemporaryFolder folder_{"mitsuba_light"};
};

/// Level tubes at random on a patch of 0.5 m, `count` of them, 6 cm long and 3 mm through.
landscape::BladeMesh straws(std::uint64_t count, const glm::vec3& reflectance,
                            const glm::vec3& transmittance) {
  constexpr double radius_m = 0.0015, length_m = 0.06, patch_m = 0.5;
  const double reach_m = radius_m * pi / (3.0 * std::sin(pi / 3.0));
  auto tubes = std::make_shared<Tubes>(Tubes{2, 3, {}, {}});
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto random = [&](const char* of) {
      return random_uniform({1, key_of("straw"), i, key_of(of)});
    };
    const glm::dvec3 root(patch_m * random("x"), patch_m * random("y"), 0.1 + 0.1 * random("z"));
    const double heading = 2.0 * pi * random("heading");
    const glm::dvec3 along(std::cos(heading), std::sin(heading), 0.0), up(0.0, 0.0, 1.0);
    const glm::dvec3 across = glm::cross(up, along);
    for (const double way_m : {0.0, length_m})
      for (int corner = 0; corner < 3; ++corner) {
        const double angle = 2.0 * pi * corner / 3.0;
        tubes->vertices_m.emplace_back(root + way_m * along +
                                       reach_m * (std::cos(angle) * across + std::sin(angle) * up));
      }
  }
  tubes->radiance.assign(2 * count, glm::vec3(0.0F));
  tubes->reflectance.assign(2 * count, reflectance);
  tubes->transmittance.assign(2 * count, transmittance);
  return {"straws", tubes};
}

void lay(const landscape::BladeMesh& mesh, Landscape& landscape) {
  landscape.blade_meshes = {mesh};
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      glm::dmat4 place(1.0);
      place[3] = {0.5 * i, 0.5 * j, 0.0, 1.0};
      landscape.blade_cells.push_back({place, 0});
    }
}

// Radiance of a Lambertian surface: irradiance times albedo over pi.
TEST_F(MitsubaLight, BareGroundUnderTheSunFollowsLambert) {
  Landscape landscape = dark();
  const double elevation = 40.0 * pi / 180.0;
  landscape.daylight.to_sun = {std::cos(elevation), 0.0, std::sin(elevation)};
  landscape.unlit->sun_irradiance = {1.3F, 1.1F, 0.7F};
  landscape.unlit->ground_albedo = ColourMap(5, 4.0, glm::vec3(0.3F, 0.2F, 0.1F));
  landscape.camera.target_m = {2.0, 2.001, -2.0};
  const Image picture = render(landscape, 4);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(mean(picture, c),
                double{landscape.unlit->sun_irradiance[c]} * std::sin(elevation) *
                    double{landscape.unlit->ground_albedo.at(0, 0)[c]} / pi,
                2e-4);
}

// In an even light, things that swallow none of it cannot be seen.
TEST_F(MitsubaLight, WhiteLeavesOnWhiteGroundUnderAnEvenSkyVanish) {
  Landscape landscape = dark();
  set_sky(landscape, 1.0F);
  landscape.unlit->ground_albedo = ColourMap(5, 4.0, glm::vec3(1.0F));
  landscape.terrain = Heightfield(5, 4.0, 0.0F);
  landscape.camera = {{2.0, 2.0, 1.0}, {2.0, 2.3, 0.1}, 40.0};
  lay(straws(600, {0.25F, 0.5F, 0.75F}, {0.75F, 0.5F, 0.25F}), landscape);
  const Image picture = render(landscape, 64);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean(picture, c), 1.0, 0.01);
}

// Leaves that swallow all light, at random in a layer: what is seen of the sky is exp(-area of what
// they show over the ground's area), Beer and Lambert's law.
TEST_F(MitsubaLight, ALayerOfBlackLeavesLetsThroughWhatItsAreaSays) {
  Landscape landscape = dark();
  set_sky(landscape, 1.0F);
  lay(straws(1000, glm::vec3(0.0F), glm::vec3(1e-4F)), landscape);
  const Image picture = render(landscape, 64);
  const double depth = 1000 * 0.003 * 0.06 / 0.25;
  EXPECT_NEAR(mean(picture, 1), std::exp(-depth), 0.05 * std::exp(-depth));
}

TEST_F(MitsubaLight, ABlackTexelLetsThroughWhatItsExtinctionSays) {
  const Landscape fog =
      test::constant_meadow({.cells_per_side = 8, .radiance = 0.0F}, folder_.path() / "texels");
  Landscape landscape = dark();
  set_sky(landscape, 1.0F);
  landscape.volumes = fog.volumes;
  landscape.cells = fog.cells;
  const Image picture = render(landscape, 256);
  const landscape::Volume& volume = fog.volumes[0];
  const double through = std::exp(-2.45 * volume.voxels.z * volume.voxel_m);
  EXPECT_NEAR(mean(picture, 1), through, 0.02);
}

// East is on the right of one who looks north.
TEST_F(MitsubaLight, TheEastOfTheSkyIsOnTheRightInTheNorth) {
  Landscape landscape = dark();
  Image& sky = landscape.unlit->sky;
  for (int y = 0; y < sky.height; ++y)
    for (int x = 0; x < sky.width / 2; ++x) std::fill_n(sky.pixel(x, y), 3, y < 8 ? 1.0F : 0.25F);
  landscape.camera = {{2.0, 2.0, 5.0}, {2.0, 100.0, 5.0}, 60.0};
  const Image picture = render(landscape, 16);
  EXPECT_NEAR(picture.pixel(20, 2)[1], 1.0F, 0.01F);
  EXPECT_NEAR(picture.pixel(3, 2)[1], 0.0F, 0.01F);
  EXPECT_NEAR(picture.pixel(20, 13)[1], 0.25F, 0.3F);
}

}  // namespace
}  // namespace wold::mitsuba
