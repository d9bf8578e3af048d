// What POV-Ray makes of an exported landscape, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "core/files.h"
#include "core/filled_map.h"
#include "core/image.h"
#include "povray/export.h"
#include "support/cloudy_view.h"
#include "support/constant_meadow.h"
#include "support/detailed_ground.h"
#include "support/povray_film.h"
#include "support/quartered.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"

namespace wold::povray {
namespace {
namespace fs = std::filesystem;

/// Inverse of the sRGB transfer function (IEC 61966-2-1).
double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

class Picture : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v povray > /dev/null") != 0)
      GTEST_SKIP() << "povray is not installed: apt-get install povray";
    folder = fs::path(testing::TempDir()) /
             (std::string("wold_picture_") +
              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  /// Not dithered: closed forms are for single pixels.
  Image render(const landscape::Landscape& scene) const {
    export_frame(scene, folder / "povray");
    export_scene(test::film_of(scene), folder / "povray");
    const std::string command = fmt::format(
        "cd {} && povray povray/data/frame_0001.ini +Opicture.png Dither=Off > log 2>&1",
        folder.string());
    if (std::system(command.c_str()) != 0) ADD_FAILURE() << read_file(folder / "log");
    return read_image(folder / "picture.png");
  }

  /// Radiance a picture shows at a pixel.
  static double radiance(const Image& picture, const landscape::Landscape& scene, int x, int y,
                         int channel = 0) {
    return linear(picture.pixel(x, y)[channel]) / scene.exposure_gain;
  }

  fs::path folder;
};

/// The pixel (not rounded) where a direction from the eye appears: a pinhole camera with x to the
/// right and y down, by the definition of the horizontal field of view.
glm::dvec2 pixel_of(const landscape::Landscape& scene, glm::dvec3 direction) {
  const glm::dvec3 forward = glm::normalize(scene.camera.target_m - scene.camera.eye_m);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double half_width = std::tan(scene.camera.field_of_view_deg * std::numbers::pi / 360.0);
  const double pixels = scene.width_px / (2.0 * half_width);
  const double depth = glm::dot(direction, forward);
  return {scene.width_px / 2.0 + pixels * glm::dot(direction, right) / depth,
          scene.height_px / 2.0 - pixels * glm::dot(direction, up) / depth};
}

/// The brightness-weighted middle of what is brighter than the threshold.
glm::dvec2 bright_spot(const Image& picture, float threshold) {
  glm::dvec2 sum(0.0);
  double weight = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (picture.pixel(x, y)[0] > threshold) {
        sum += glm::dvec2(x + 0.5, y + 0.5);
        weight += 1.0;
      }
  EXPECT_GT(weight, 0.0) << "no marker in the picture";
  return sum / std::max(weight, 1.0);
}

// Looking straight down from far away every ray crosses the same optical depth tau = 2.45 1/m x 8
// voxels of 1/28 m = 0.7, so it shows L (1 - exp(-tau)) + G exp(-tau) (Beer-Lambert), also where it
// passes from cell to cell or from quarter to quarter of one.
TEST_F(Picture, FogFollowsBeerLambertWithoutSeams) {
  const test::ConstantMeadow fog;
  landscape::Landscape scene = test::constant_meadow(fog, folder / "texels");
  test::quarter_cells(scene);
  scene.camera = {{1.6, 1.55, 60.0}, {1.6, 1.56, 0.0}, 2.0};
  const Image picture = render(scene);
  const double through = std::exp(-0.7);
  const double expected = fog.radiance * (1.0 - through) + fog.ground * through;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      ASSERT_NEAR(radiance(picture, scene, x, y), expected, 0.01 * expected) << x << ", " << y;
}

// Dense fog on a slope hides the ground from a low eye: every pixel of grass has the fog's own
// radiance, with no line of ground or sky between cells.
TEST_F(Picture, DenseFogOnASlopeHasNoHoles) {
  test::ConstantMeadow fog;
  fog.extinction = 10.0F;
  fog.slope = 0.2;
  landscape::Landscape scene = test::constant_meadow(fog, folder / "texels");
  test::quarter_cells(scene);
  scene.camera = {{1.5, -1.5, 1.4}, {1.5, 1.5, 0.5}, 40.0};
  const Image picture = render(scene);
  for (int y = picture.height / 2; y < picture.height - 8; ++y)
    for (int x = 24; x < picture.width - 24; ++x)
      ASSERT_NEAR(radiance(picture, scene, x, y), fog.radiance, 0.02 * fog.radiance)
          << x << ", " << y;
}

// Blades show their own radiance times the finest light of the place, whole and nowhere else.
TEST_F(Picture, BladesShowTheirRadianceTimesTheLight) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  scene.cells.clear();
  const glm::vec3 light(0.5F, 0.8F, 1.6F);
  scene.light_details = {ColourMap(5, {glm::dvec2(-3.0), 9.0}, light)};
  const glm::vec3 own(0.16F, 0.05F, 0.1F);
  scene.blade_meshes = {test::pillar("pillar", 0.2, 0.4, own)};
  const glm::dvec3 foot(1.75, 1.25, 0.0);
  scene.blade_cells = {{glm::translate(glm::dmat4(1.0), foot - glm::dvec3(0.25, 0.25, 0.0)), 0}};
  scene.camera = {{1.5, -1.0, 0.6}, {1.5, 1.5, 0.2}, 40.0};
  const Image picture = render(scene);
  const auto shown = [&](const glm::dvec3& place, int channel) {
    const glm::dvec2 at = pixel_of(scene, place - scene.camera.eye_m);
    return radiance(picture, scene, static_cast<int>(at.x), static_cast<int>(at.y), channel);
  };
  for (int channel = 0; channel < 3; ++channel) {
    const double wanted = double{own[channel] * light[channel]};
    EXPECT_NEAR(shown(foot + glm::dvec3(-0.07, -0.1, 0.1), channel), wanted, 0.02 * wanted);
    EXPECT_NEAR(shown(foot + glm::dvec3(0.07, -0.1, 0.3), channel), wanted, 0.02 * wanted);
    EXPECT_NEAR(shown(foot + glm::dvec3(-0.2, -0.1, 0.0), channel), 0.02, 0.001);  // the ground
  }
}

// They hang over the terrain's edge, where its maps end: they were black there.
TEST_F(Picture, BladesBeyondTheGroundAreLitAsAtItsEdge) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  scene.cells.clear();
  const float own = 0.1F;
  scene.blade_meshes = {test::pillar("pillar", 0.2, 0.4, glm::vec3(own))};
  const glm::dvec3 foot(3.4, 1.25, 0.0);  // the ground ends at 3
  scene.blade_cells = {{glm::translate(glm::dmat4(1.0), foot - glm::dvec3(0.25, 0.25, 0.0)), 0}};
  scene.camera = {{3.4, -1.0, 0.6}, {3.4, 1.5, 0.2}, 40.0};
  const Image picture = render(scene);
  const glm::dvec2 at = pixel_of(scene, foot + glm::dvec3(0.0, -0.1, 0.2) - scene.camera.eye_m);
  EXPECT_NEAR(radiance(picture, scene, static_cast<int>(at.x), static_cast<int>(at.y)), own,
              0.02 * own);
}

TEST_F(Picture, SkyShowsADirectionWhereTheCameraSeesIt) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  scene.sky = Image(360, 180, 3);
  const int column = 20;  // azimuth 20.5 degrees: east of north, so on the right
  const int row = 69;     // elevation 20.5 degrees
  for (int channel = 0; channel < 3; ++channel) scene.sky.pixel(column, row)[channel] = 0.25F;
  scene.camera = {{1.5, 1.5, 5.0}, {1.5, 4.5, 6.0}, 60.0};
  scene.cells.clear();
  const double azimuth = 20.5 * std::numbers::pi / 180.0;
  const double elevation = 20.5 * std::numbers::pi / 180.0;
  const glm::dvec3 direction(std::cos(elevation) * std::sin(azimuth),
                             std::cos(elevation) * std::cos(azimuth), std::sin(elevation));
  const glm::dvec2 wanted = pixel_of(scene, direction);
  ASSERT_GT(wanted.x, scene.width_px / 2.0);
  const glm::dvec2 found = bright_spot(render(scene), 0.6F);
  EXPECT_NEAR(found.x, wanted.x, 0.75);
  EXPECT_NEAR(found.y, wanted.y, 0.75);
}

TEST_F(Picture, GroundShowsAPlaceWhereTheCameraSeesIt) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  scene.cells.clear();
  scene.terrain = Heightfield(25, 3.0);
  std::fill(scene.ground.values().begin(), scene.ground.values().end(), glm::vec3(0.0F));
  scene.ground.at(18, 14) = glm::vec3(0.25F);  // x = 2.25 m, y = 1.75 m: east, so on the right
  scene.camera = {{1.5, -1.0, 1.5}, {1.5, 1.5, 0.0}, 50.0};
  scene.sky = Image(4, 2, 3);
  const glm::dvec2 wanted = pixel_of(scene, glm::dvec3(2.25, 1.75, -0.004) - scene.camera.eye_m);
  ASSERT_GT(wanted.x, scene.width_px / 2.0);
  const Image picture = render(scene);
  const glm::dvec2 found = bright_spot(picture, 0.6F);
  EXPECT_NEAR(found.x, wanted.x, 0.75);
  EXPECT_NEAR(found.y, wanted.y, 0.75);
}

// Each at its place and sharp: a sample's colour, not a mean of two.
TEST_F(Picture, FinerPicturesOfTheGroundAreSeenWhereTheyAre) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  test::make_detailed_ground(scene);
  const Image picture = render(scene);
  for (const auto& [place_m, wanted, tolerance] : test::places_of_detailed_ground()) {
    const glm::dvec2 at = pixel_of(scene, place_m - scene.camera.eye_m);
    EXPECT_NEAR(radiance(picture, scene, static_cast<int>(at.x), static_cast<int>(at.y)), wanted,
                tolerance)
        << place_m.x << ", " << place_m.y;
  }
}

// Light that grows eastward in red and northward in blue on grass that grows northward, seen from
// above: Beer-Lambert with the maps by world x and y, also in cells turned about their middle.
TEST_F(Picture, LightAndGrowthFollowTheWorldNotTheCell) {
  test::ConstantMeadow fog;
  fog.extinction = 12.0F;
  landscape::Landscape scene = test::constant_meadow(fog, folder / "texels");
  const double step_m = scene.light.step_m();
  for (int j = 0; j < scene.light.samples(); ++j)
    for (int i = 0; i < scene.light.samples(); ++i)
      scene.light.at(i, j) = glm::vec3(static_cast<float>(i * step_m / 3.0), 1.0F,
                                       static_cast<float>(j * step_m / 3.0));
  for (int j = 0; j < scene.extinction_factor.samples(); ++j)
    for (int i = 0; i < scene.extinction_factor.samples(); ++i)
      scene.extinction_factor.at(i, j) =
          static_cast<float>(0.5 + j * scene.extinction_factor.step_m() / 3.0);
  const glm::dmat4 quarter_turn({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0.5, 0, 0, 1});
  for (std::size_t cell = 0; cell < scene.cells.size(); cell += 2)
    scene.cells[cell].world_from_cell = scene.cells[cell].world_from_cell * quarter_turn;
  scene.camera = {{1.5, 1.499, 60.0}, {1.5, 1.5, 0.0}, 2.0};
  const Image picture = render(scene);
  const double metres_per_pixel =
      2.0 * (60.0 - 0.3) * std::tan(1.0 * std::numbers::pi / 180.0) / scene.width_px;
  const auto expected = [&](double light, double north_m) {
    const double through = std::exp(-12.0 * (0.5 + north_m / 3.0) * 8.0 / 28.0);
    return fog.radiance * light * (1.0 - through) + fog.ground * through;
  };
  for (int y = 2; y < picture.height; y += 5)
    for (int x = 2; x < picture.width; x += 5) {
      const double east_m = 1.5 + (x + 0.5 - scene.width_px / 2.0) * metres_per_pixel;
      const double north_m = 1.5 - (y + 0.5 - scene.height_px / 2.0) * metres_per_pixel;
      EXPECT_NEAR(radiance(picture, scene, x, y, 0), expected(east_m / 3.0, north_m), 0.001);
      EXPECT_NEAR(radiance(picture, scene, x, y, 1), expected(1.0, north_m), 0.001);
      EXPECT_NEAR(radiance(picture, scene, x, y, 2), expected(north_m / 3.0, north_m), 0.001);
    }
}

// A map that covers the cells from 1 to 2 m and half a metre around them. On it light grows
// eastward in red and northward in blue.
TEST_F(Picture, GrassIsLitByTheFinestMapThatCoversIt) {
  test::ConstantMeadow fog;
  fog.extinction = 12.0F;
  landscape::Landscape scene = test::constant_meadow(fog, folder / "texels");
  scene.light_details = {filled<ColourMap>({{{0.4, 0.6}, 2.0}, 41}, [](const glm::dvec2& at_m) {
    return glm::vec3(0.2 + at_m.x / 3.0, 1.5, 0.4 + at_m.y / 3.0);
  })};
  scene.camera = {{1.5, 1.499, 60.0}, {1.5, 1.5, 0.0}, 2.0};
  const Image picture = render(scene);
  const double metres_per_pixel =
      2.0 * (60.0 - 0.3) * std::tan(1.0 * std::numbers::pi / 180.0) / scene.width_px;
  const double through = std::exp(-12.0 * 8.0 / 28.0);
  for (int y = 2; y < picture.height; y += 4)
    for (int x = 2; x < picture.width; x += 4) {
      const glm::dvec2 at_m(1.5 + (x + 0.5 - scene.width_px / 2.0) * metres_per_pixel,
                            1.5 - (y + 0.5 - scene.height_px / 2.0) * metres_per_pixel);
      const glm::dvec2 off_m = glm::abs(at_m - 1.5);
      const double farthest_m = std::max(off_m.x, off_m.y);
      if (std::abs(farthest_m - 0.5) < 0.03) continue;
      for (int c = 0; c < 3; ++c) {
        const std::array<double, 3> finer = {0.2 + at_m.x / 3.0, 1.5, 0.4 + at_m.y / 3.0};
        const double light = farthest_m < 0.5 ? finer[static_cast<std::size_t>(c)] : 1.0;
        EXPECT_NEAR(radiance(picture, scene, x, y, c),
                    fog.radiance * light * (1.0 - through) + fog.ground * through, 0.001)
            << at_m.x << ", " << at_m.y;
      }
    }
}

// A cloud stands in the air, and behind it the backdrop, the right way up.
TEST_F(Picture, CloudsAreBeforeTheBackdrop) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  test::make_cloudy_view(scene);
  const Image picture = render(scene);
  for (const glm::dvec3 direction : {glm::dvec3(0.02, 1.0, 0.12), glm::dvec3(0.1, 1.0, 0.3),
                                     glm::dvec3(0.2, 1.0, 0.25), glm::dvec3(-0.2, 1.0, 0.1)}) {
    const glm::dvec3 unit = glm::normalize(direction);
    const glm::dvec2 at = pixel_of(scene, unit);
    const double wanted = test::radiance_of_cloudy_view(scene, unit);
    EXPECT_NEAR(radiance(picture, scene, static_cast<int>(at.x), static_cast<int>(at.y)), wanted,
                0.02 * wanted);
  }
}

// Clouds once repeated themselves as patches of grass do: an even one looked right all the same.
TEST_F(Picture, ACloudIsWhereItsVoxelsAre) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  test::make_cloudy_view(scene);
  landscape::CloudBox& cloud = scene.clouds.front();
  for (std::size_t i = 0; i < cloud.extinction_per_m.size(); ++i)
    if (static_cast<int>(i) % cloud.voxels.x < 6) cloud.extinction_per_m[i] = 0.0F;
  const Image picture = render(scene);
  const auto seen = [&](const glm::dvec3& direction) {
    const glm::dvec2 at = pixel_of(scene, glm::normalize(direction));
    return radiance(picture, scene, static_cast<int>(at.x), static_cast<int>(at.y));
  };
  const glm::dvec3 west(0.02, 1.0, 0.12), east(0.3, 1.0, 0.12);
  const double wanted = test::radiance_of_cloudy_view(scene, glm::normalize(east));
  EXPECT_NEAR(seen(east), wanted, 0.02 * wanted);
  scene.clouds.clear();
  const Image clear = render(scene);
  const glm::dvec2 at = pixel_of(scene, glm::normalize(west));
  const double behind = radiance(clear, scene, static_cast<int>(at.x), static_cast<int>(at.y));
  EXPECT_NEAR(seen(west), behind, 0.02 * behind);
}

// Flakes let through what they do not cover, from both sides, and fog lies between them all.
TEST_F(Picture, FlakesAndFogShowWhatTheirFormulaeSay) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  test::make_snowy_view(scene);
  scene.flakes.flakes[1].right_m *= -1.0F;  // seen from behind
  const Image picture = render(scene);
  for (const glm::dvec3& direction : test::directions_of_snowy_view()) {
    const glm::dvec2 at = pixel_of(scene, direction);
    const double wanted = test::radiance_of_snowy_view(scene, direction);
    EXPECT_NEAR(radiance(picture, scene, static_cast<int>(at.x), static_cast<int>(at.y), 1), wanted,
                0.015 * wanted)
        << direction.x << ", " << direction.y << ", " << direction.z;
  }
}

// Names are POV-Ray's strings: a quote must not end one, nor a backslash begin an escape.
TEST_F(Picture, NamesWithQuotesAndBackslashesAreFound) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  landscape::Landscape cloudy = scene;
  test::make_cloudy_view(cloudy);
  scene.clouds = cloudy.clouds;
  test::add_flakes(scene, 30, 4.0);
  const Image wanted = render(scene);
  const std::string odd = "\"; #error \\n\\";
  for (landscape::Volume& volume : scene.volumes) volume.name += odd;
  for (landscape::BladeMesh& mesh : scene.blade_meshes) mesh.name += odd;
  for (landscape::CloudBox& cloud : scene.clouds) cloud.name += odd;
  for (landscape::FlakePicture& picture : scene.flakes.pictures) picture.name += odd;
  EXPECT_EQ(render(scene).values, wanted.values);
}

/// Whether pictures differ by a step of 8 bits at most, as one that is dithered does.
bool are_a_step_apart(const Image& a, const Image& b) {
  return std::ranges::equal(a.values, b.values,
                            [](float x, float y) { return std::abs(x - y) < 1.01F / 255.0F; });
}

TEST_F(Picture, BareCommandsWorkHereAndFromAbove) {
  landscape::Landscape scene = test::constant_meadow({}, folder / "texels");
  scene.cells.resize(1);
  render(scene);
  const Image wanted = read_image(folder / "picture.png");
  const std::string go = "cd " + folder.string() + "/povray && povray scene.pov > log 2>&1";
  ASSERT_EQ(std::system(go.c_str()), 0) << read_file(folder / "povray/log");
  EXPECT_TRUE(are_a_step_apart(read_image(folder / "povray/scene.png"), wanted));
  fs::remove(folder / "povray/scene.png");
  const std::string above = fmt::format("cd {} && povray povray/scene.pov +W{} +H{} -D > log 2>&1",
                                        folder.string(), wanted.width, wanted.height);
  ASSERT_EQ(std::system(above.c_str()), 0) << read_file(folder / "log");
  EXPECT_TRUE(are_a_step_apart(read_image(folder / "povray/scene.png"), wanted));
}

}  // namespace
}  // namespace wold::povray
