// The package wold_blender in Blender itself ($WOLD_BLENDER): where things appear and how bright,
// against closed forms. Skipped where there is no Blender.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <regex>

#include "blender/export.h"
#include "core/files.h"
#include "core/filled_map.h"
#include "core/image.h"
#include "core/vdb_file.h"
#include "support/blender.h"
#include "support/cloudy_view.h"
#include "support/detailed_ground.h"
#include "support/quartered.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

constexpr double degree = std::numbers::pi / 180.0;

class BlenderRender : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::shows_volumes())
      GTEST_SKIP() << "no Blender that shows volumes on this machine: its pictures are not tested";
    fs::remove_all(folder);
    landscape = test::synthetic_landscape({.cells_per_side = 6, .volumes = 1}, folder / "texels");
    landscape.blade_cells.clear();
    landscape.samples = 4;
    landscape.exposure_gain = 2.0;
    landscape.light.values().assign(landscape.light.values().size(), glm::vec3(1.0F));
  }
  void TearDown() override { fs::remove_all(folder); }

  /// Exit status of Blender; what it says goes to folder/log.
  int run() {
    export_frame(landscape, folder);
    return rerun();
  }
  int rerun() const {
    return std::system(fmt::format("{0} --out {1}/picture.png > {1}/log 2>&1",
                                   test::blender_render(folder, 1), folder.string())
                           .c_str());
  }

  /// Replaces the only volume: `fill` sets its voxels.
  template <class Fill>
  void make_volume(int height_voxels, const Fill& fill) {
    auto density = openvdb::FloatGrid::create(0.0F);
    auto emission = openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F));
    density->setName("density");
    emission->setName("emission_q0");
    fill(*density, *emission);
    landscape::Volume& volume = landscape.volumes.front();
    volume.voxels.z = height_voxels;
    write_vdb(volume.vdb, {density, emission});
  }

  const fs::path folder =
      fs::path(testing::TempDir()) / ("wold_blender_render_" + std::to_string(::getpid()));
  Landscape landscape;
};

float linear_of(float srgb) {  // IEC 61966-2-1
  return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

/// Looks along -z of a camera at `eye` to `target`, up is +z.
struct Eye {
  glm::dvec3 eye, forward, right, up;
  double focal_px, centre_x, centre_y;

  explicit Eye(const Landscape& landscape)
      : eye(landscape.camera.eye_m),
        forward(glm::normalize(landscape.camera.target_m - eye)),
        right(glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)))),
        up(glm::cross(right, forward)),
        focal_px(0.5 * landscape.width_px /
                 std::tan(0.5 * landscape.camera.field_of_view_deg * degree)),
        centre_x(0.5 * landscape.width_px),
        centre_y(0.5 * landscape.height_px) {}

  glm::dvec2 pixel_of_direction(const glm::dvec3& d) const {
    const double scale = focal_px / glm::dot(d, forward);
    return {centre_x + scale * glm::dot(d, right), centre_y - scale * glm::dot(d, up)};
  }
  glm::dvec3 direction_of_pixel(double x, double y) const {
    return glm::normalize(forward + right * ((x - centre_x) / focal_px) -
                          up * ((y - centre_y) / focal_px));
  }
};

/// Centre of brightness of a channel, in pixels.
glm::dvec2 centroid(const Image& picture, int channel) {
  glm::dvec2 sum(0.0);
  double weight = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double value = linear_of(picture.pixel(x, y)[channel]);
      sum += value * glm::dvec2(x + 0.5, y + 0.5);
      weight += value;
    }
  return sum / weight;
}

// Blades show their own radiance times the finest light of the place, whole and nowhere else.
TEST_F(BlenderRender, BladesShowTheirRadianceTimesTheLight) {
  landscape.cells.clear();
  const glm::vec3 light(0.5F, 0.8F, 1.6F);
  landscape.light_details = {ColourMap(5, {glm::dvec2(-3.0), 9.0}, light)};
  std::fill(landscape.ground.values().begin(), landscape.ground.values().end(), glm::vec3(0.02F));
  std::fill(landscape.terrain.values().begin(), landscape.terrain.values().end(), 0.0F);
  const glm::vec3 own(0.16F, 0.05F, 0.1F);
  landscape.blade_meshes = {test::pillar("pillar", 0.2, 0.4, own)};
  const glm::dvec3 foot(1.75, 1.25, 0.0);
  landscape.blade_cells = {
      {glm::translate(glm::dmat4(1.0), foot - glm::dvec3(0.25, 0.25, 0.0)), 0}};
  landscape.camera = {{1.5, -1.0, 0.6}, {1.5, 1.5, 0.2}, 40.0};
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  const Image picture = read_image(folder / "picture.png");
  const Eye eye(landscape);
  const auto shown = [&](const glm::dvec3& place, int channel) {
    const glm::dvec2 at = eye.pixel_of_direction(place - landscape.camera.eye_m);
    const float value = picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y))[channel];
    return double{linear_of(value)} / landscape.exposure_gain;
  };
  for (int channel = 0; channel < 3; ++channel) {
    const double wanted = double{own[channel] * light[channel]};
    EXPECT_NEAR(shown(foot + glm::dvec3(-0.07, -0.1, 0.1), channel), wanted, 0.02 * wanted);
    EXPECT_NEAR(shown(foot + glm::dvec3(0.07, -0.1, 0.3), channel), wanted, 0.02 * wanted);
    EXPECT_NEAR(shown(foot + glm::dvec3(-0.2, -0.1, 0.0), channel), 0.02, 0.001);  // the ground
  }
}

// A red mark in the sky, one green voxel and a blue ground, each where the landscape puts it.
TEST_F(BlenderRender, SkyVoxelAndGroundAppearWhereTheyAre) {
  const openvdb::Coord voxel(10, 21, 27);
  make_volume(30, [&](openvdb::FloatGrid& density, openvdb::Vec3SGrid& emission) {
    density.tree().setValue(voxel, 400.0F);
    emission.tree().setValue(voxel, openvdb::Vec3s(0.0F, 0.3F, 0.0F));
  });
  landscape.cells.resize(1);
  landscape.cells[0].world_from_cell =
      glm::dmat4({1, 0, 0.2, 0}, {0, 1, 0.3, 0}, {0, 0, 1, 0}, {1.0, 0.75, 0.9, 1});
  landscape.sky = Image(360, 180, 3);
  const int azimuth_deg = 10;
  const int elevation_deg = 12;
  landscape.sky.pixel(azimuth_deg, 89 - elevation_deg)[0] = 0.4F;
  landscape.ground.values().assign(landscape.ground.values().size(), glm::vec3(0, 0, 0.09F));
  landscape.camera = {{1.6, -1.0, 0.8}, {1.5, 0.9, 0.95}, 40.0};
  landscape.width_px = 320;
  landscape.height_px = 240;
  landscape.samples = 16;
  ASSERT_EQ(run(), 0) << read_file(folder / "log");

  const Image picture = read_image(folder / "picture.png");
  const Eye eye(landscape);
  const double azimuth = (azimuth_deg + 0.5) * degree;
  const double elevation = (elevation_deg + 0.5) * degree;
  const glm::dvec2 mark =
      eye.pixel_of_direction({std::sin(azimuth) * std::cos(elevation),
                              std::cos(azimuth) * std::cos(elevation), std::sin(elevation)});
  EXPECT_LT(glm::distance(centroid(picture, 0), mark), 0.3);

  const double voxel_m = landscape.volumes[0].voxel_m;
  const glm::dvec4 place = landscape.cells[0].world_from_cell *
                           glm::dvec4((voxel.x() - 0.5) * voxel_m, (voxel.y() - 0.5) * voxel_m,
                                      (voxel.z() - 0.5) * voxel_m, 1.0);
  const glm::dvec2 wanted = eye.pixel_of_direction(glm::dvec3(place) - eye.eye);
  const double voxel_px = eye.focal_px * voxel_m / 1.9;
  EXPECT_LT(glm::distance(centroid(picture, 1), wanted), 0.12 * voxel_px);

  // 0.09 twice over is 0.18, which sRGB encodes as 0.4613.
  EXPECT_NEAR(picture.pixel(160, 239)[2], 0.4613F, 1.0F / 255.0F);
}

// Opaque columns, each eight voxels wide, in four colours and at two brightnesses, seen from above
// on a turned cell, whole and in quarters: each shows its radiance, whatever Blender interpolates.
TEST_F(BlenderRender, ColoursOfAVolumeAreWhereTheyAre) {
  const std::array<glm::vec3, 4> colours = {glm::vec3(0.05F, 0.1F, 0.02F),
                                            {0.12F, 0.1F, 0.04F},
                                            {0.02F, 0.06F, 0.09F},
                                            {0.1F, 0.05F, 0.06F}};
  const auto radiance_at = [&](int x, int y) {
    const auto colour = static_cast<std::size_t>(x / 8 + y / 8) % colours.size();
    return (x / 8 % 2 == 0 ? 1.0F : 0.5F) * colours[colour];
  };
  constexpr int height = 12;
  make_volume(height, [&](openvdb::FloatGrid& density, openvdb::Vec3SGrid& emission) {
    const openvdb::CoordBBox box(openvdb::Coord(1), openvdb::Coord(30, 30, height));
    density.fill(box, 3000.0F);
    for (auto at = box.begin(); at; ++at) {
      const glm::vec3 own = radiance_at((*at).x() - 1, (*at).y() - 1);
      // Below the upper half is another colour, which nobody sees.
      emission.tree().setValue(*at, (*at).z() > height / 2 ? openvdb::Vec3s(own.r, own.g, own.b)
                                                           : openvdb::Vec3s(0.2F, 0.0F, 0.2F));
    }
  });
  landscape.cells.resize(1);
  const double side_m = landscape.patch_m;
  landscape.cells[0].world_from_cell =
      glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {1.0 + side_m, 1.0, 0.0, 1});
  landscape.terrain.values().assign(landscape.terrain.values().size(), -1.0F);
  landscape.camera = {{1.0 + 0.5 * side_m, 1.0 + 0.49 * side_m, 3.0},
                      {1.0 + 0.5 * side_m, 1.0 + 0.5 * side_m, 0.1},
                      12.0};
  landscape.width_px = 160;
  landscape.height_px = 160;
  const double voxel_m = landscape.volumes[0].voxel_m;
  for (const bool quartered : {false, true}) {
    if (quartered) test::quarter_cells(landscape);
    ASSERT_EQ(run(), 0) << read_file(folder / "log");
    const Image picture = read_image(folder / "picture.png");
    const Eye eye(landscape);
    for (int y = 4; y < 30; y += 8)
      for (int x = 4; x < 30; x += 8) {
        const glm::dvec3 place(landscape.cells[0].world_from_cell *
                               glm::dvec4(x * voxel_m, y * voxel_m, height * voxel_m, 1.0));
        const glm::dvec2 px = eye.pixel_of_direction(place - eye.eye);
        const float* shown = picture.pixel(static_cast<int>(px.x), static_cast<int>(px.y));
        const glm::vec3 wanted = radiance_at(x, y);
        for (int channel = 0; channel < 3; ++channel)
          EXPECT_NEAR(linear_of(shown[channel]) / landscape.exposure_gain, wanted[channel],
                      0.02F * wanted[channel] + 0.002F)
              << x << ", " << y << ", channel " << channel << ", quarters " << quartered;
      }
  }
}

// Constant extinction and source radiance over 6 x 6 sheared cells of which half stands, at last
// every other one in quarters: along every ray the radiance is S (1 - exp(-extinction length)),
// whatever joints it crosses.
TEST_F(BlenderRender, JointsOfCellsCannotBeSeen) {
  constexpr float extinction = 2.5F;
  constexpr int height = 22;
  constexpr double slope = 0.15;
  make_volume(height, [&](openvdb::FloatGrid& density, openvdb::Vec3SGrid& emission) {
    const openvdb::CoordBBox box(openvdb::Coord(1), openvdb::Coord(30, 30, height));
    density.fill(box, 2.0F * extinction);
    emission.fill(box, openvdb::Vec3s(0.2F));
  });
  landscape.extinction_factor.values().assign(landscape.extinction_factor.values().size(), 0.5F);
  for (landscape::Cell& cell : landscape.cells) {
    glm::dmat4& m = cell.world_from_cell;
    m = glm::dmat4({1, 0, 0, 0}, {0, 1, slope, 0}, {0, 0, 1, 0},
                   {m[3].x, m[3].y, slope * m[3].y, 1});
  }
  landscape.terrain.values().assign(landscape.terrain.values().size(), -5.0F);
  landscape.ground.values().assign(landscape.ground.values().size(), glm::vec3(0.0F));
  landscape.sky = Image(8, 4, 3);
  landscape.width_px = 160;
  landscape.height_px = 90;
  const double thickness_m = height * landscape.volumes[0].voxel_m;
  const std::array<glm::dvec3, 2> eyes_m = {glm::dvec3(1.53, 1.4, 4.0), {1.6, -0.4, 1.1}};
  for (int number = 0; number < 4; ++number) {
    const glm::dvec3& from = eyes_m[static_cast<std::size_t>(number % 2)];
    if (number == 2) test::quarter_cells(landscape);
    // Rays cross twice as many joints, each of which may be off.
    const double max_off = number < 2 ? 0.008 : 0.012;
    landscape.camera = {from, {1.5, 1.6, 0.3}, from.z > 2.0 ? 30.0 : 34.0};
    ASSERT_EQ(run(), 0) << read_file(folder / "log");
    const Image picture = read_image(folder / "picture.png");
    const Eye eye(landscape);
    int inside = 0;
    double error = 0.0, squares = 0.0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const glm::dvec3 d = eye.direction_of_pixel(x + 0.5, y + 0.5);
        const double sinking = slope * d.y - d.z;  // below the slope per metre of the ray
        const double enters = (from.z - slope * from.y - thickness_m) / sinking;
        const double length = thickness_m / sinking;
        const glm::dvec3 in = from + enters * d;
        const glm::dvec3 out = in + length * d;
        if (sinking <= 0.0 || std::min({in.x, in.y, out.x, out.y}) < 0.05 ||
            std::max({in.x, in.y, out.x, out.y}) > 2.95)
          continue;  // beside the meadow
        ++inside;
        const double want = 2.0 * 0.2 * (1.0 - std::exp(-extinction * length));
        const double off = linear_of(picture.pixel(x, y)[1]) - want;
        ASSERT_LT(std::abs(off), max_off) << "view " << number << ", pixel " << x << ", " << y;
        error += off;
        squares += off * off;
      }
    EXPECT_GT(inside, 160 * 90 / 3);
    EXPECT_LT(std::abs(error / inside), 0.0005);
    EXPECT_LT(std::sqrt(squares / inside), 0.002);
  }
}

/// What the renderer has held at once, by its own count, in MB.
double peak_mb(const std::string& log) {
  static const std::regex peak(R"(\| Mem:[0-9.]+M, Peak:([0-9.]+)M \|)");
  double max = 0.0;
  for (std::sregex_iterator found(log.begin(), log.end(), peak), end; found != end; ++found)
    max = std::max(max, std::stod((*found)[1]));
  return max;
}

// A volume of 126^3 takes 26 MB, where colours as grids took 41: as much whole, in quarters, in
// parts of them, and all at once, but for the quarters' masks.
TEST_F(BlenderRender, PartsOfAVolumeShareItInMemory) {
  landscape::Volume& volume = landscape.volumes.front();
  const int voxels = 126;
  volume.voxel_m *= static_cast<double>(volume.voxels.x) / voxels;
  volume.voxels = glm::ivec3(voxels);
  make_volume(voxels, [&](openvdb::FloatGrid& density, openvdb::Vec3SGrid& emission) {
    const openvdb::CoordBBox box(openvdb::Coord(1), openvdb::Coord(voxels));
    density.fill(box, 5.0F);
    emission.fill(box, openvdb::Vec3s(0.2F));
  });
  for (landscape::Cell& cell : landscape.cells) cell.volume = 0;
  landscape.width_px = 32;
  landscape.height_px = 18;
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  const double whole_mb = peak_mb(read_file(folder / "log"));
  EXPECT_GT(whole_mb, 25.0);
  EXPECT_LT(whole_mb, 30.0);
  test::quarter_cells(landscape);
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  EXPECT_LT(peak_mb(read_file(folder / "log")), whole_mb + 10.0);
}

// Cycles holds the bounds of volumes against each other's, for which it took five times as long for
// four times the cells, and more than ten minutes for hundreds of thousands.
TEST_F(BlenderRender, TimeGrowsNoFasterThanTheNumberOfCells) {
  landscape.width_px = 16;
  landscape.height_px = 9;
  landscape.samples = 1;
  const auto seconds = [&](int cells_per_side) {
    const Landscape grown = test::synthetic_landscape(
        {.cells_per_side = cells_per_side, .volumes = 1}, folder / "texels");
    landscape.terrain = grown.terrain;
    landscape.cells = grown.cells;
    export_frame(landscape, folder);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(rerun(), 0) << read_file(folder / "log");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double some_s = seconds(125);
  EXPECT_LT(seconds(250), 4.0 * some_s);
}

// A cloud stands in the air, and behind it the backdrop, the right way up.
TEST_F(BlenderRender, CloudsAreBeforeTheBackdrop) {
  test::make_cloudy_view(landscape);
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  const Image picture = read_image(folder / "picture.png");
  const Eye eye(landscape);
  for (const glm::dvec3 direction : {glm::dvec3(0.02, 1.0, 0.12), glm::dvec3(0.1, 1.0, 0.3),
                                     glm::dvec3(0.2, 1.0, 0.25), glm::dvec3(-0.2, 1.0, 0.1)}) {
    const glm::dvec3 unit = glm::normalize(direction);
    const glm::dvec2 at = eye.pixel_of_direction(unit);
    const double wanted = test::radiance_of_cloudy_view(landscape, unit);
    const float value = picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y))[1];
    EXPECT_NEAR(double{linear_of(value)} / landscape.exposure_gain, wanted, 0.03 * wanted);
  }
}

// Flakes let through what they do not cover, from both sides, and fog lies between them all.
TEST_F(BlenderRender, FlakesAndFogShowWhatTheirFormulaeSay) {
  test::make_snowy_view(landscape);
  landscape.flakes.flakes[1].right_m *= -1.0F;  // seen from behind
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  const Image picture = read_image(folder / "picture.png");
  const Eye eye(landscape);
  for (const glm::dvec3& direction : test::directions_of_snowy_view()) {
    const glm::dvec2 at = eye.pixel_of_direction(direction);
    const double wanted = test::radiance_of_snowy_view(landscape, direction);
    const float value = picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y))[1];
    EXPECT_NEAR(double{linear_of(value)} / landscape.exposure_gain, wanted, 0.015 * wanted)
        << direction.x << ", " << direction.y << ", " << direction.z;
  }
}

// A map that covers the cells from 1 to 2 m and half a metre around them. On it light grows
// eastward in red and northward in blue.
TEST_F(BlenderRender, GrassIsLitByTheFinestMapThatCoversIt) {
  make_volume(22, [&](openvdb::FloatGrid& density, openvdb::Vec3SGrid& emission) {
    const openvdb::CoordBBox box(openvdb::Coord(1), openvdb::Coord(30, 30, 22));
    density.fill(box, 20.0F);
    emission.fill(box, openvdb::Vec3s(0.2F));
  });
  for (landscape::Cell& cell : landscape.cells) {
    const glm::dvec4 corner_m = cell.world_from_cell[3];
    cell.world_from_cell = glm::dmat4(1.0);
    cell.world_from_cell[3] = {corner_m.x, corner_m.y, 0.0, 1.0};
  }
  landscape.terrain.values().assign(landscape.terrain.values().size(), 0.0F);
  landscape.extinction_factor.values().assign(landscape.extinction_factor.values().size(), 1.0F);
  const auto finer = [](const glm::dvec2& at_m) {
    return glm::vec3(0.2 + at_m.x / 3.0, 1.5, 0.4 + at_m.y / 3.0);
  };
  landscape.light_details = {filled<ColourMap>({{{0.4, 0.6}, 2.0}, 41}, finer)};
  landscape.camera = {{1.5, 1.499, 60.0}, {1.5, 1.5, 0.0}, 2.5};
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  const Image picture = read_image(folder / "picture.png");
  const Eye eye(landscape);
  const auto shown = [&](const glm::dvec2& at_m, int channel) {
    const glm::dvec2 at = eye.pixel_of_direction(glm::dvec3(at_m, 0.3) - landscape.camera.eye_m);
    return double{
        linear_of(picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y))[channel])};
  };
  for (const double off_m : {-0.4, 0.0, 0.4})
    for (int channel = 0; channel < 3; ++channel) {
      const double beside = shown({0.75, 1.5 + off_m}, channel);
      EXPECT_GT(beside, 0.05);
      const glm::dvec2 at_m(1.5 + off_m, 1.5 + 0.5 * off_m);
      EXPECT_NEAR(shown(at_m, channel) / beside, finer(at_m)[channel], 0.03)
          << off_m << ", channel " << channel;
    }
}

// Each at its place and sharp: a sample's colour, not a mean of two.
TEST_F(BlenderRender, FinerPicturesOfTheGroundAreSeenWhereTheyAre) {
  test::make_detailed_ground(landscape);
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  const Image picture = read_image(folder / "picture.png");
  const Eye eye(landscape);
  for (const auto& [place_m, wanted, tolerance] : test::places_of_detailed_ground()) {
    const glm::dvec2 at = eye.pixel_of_direction(place_m - landscape.camera.eye_m);
    const float value = picture.pixel(static_cast<int>(at.x), static_cast<int>(at.y))[1];
    EXPECT_NEAR(double{linear_of(value)} / landscape.exposure_gain, wanted, tolerance)
        << place_m.x << ", " << place_m.y;
  }
}

TEST_F(BlenderRender, TruncatedVolumeIsRefusedByName) {
  landscape.cells.resize(1);
  ASSERT_EQ(run(), 0) << read_file(folder / "log");
  fs::remove(folder / "picture.png");
  const std::string name = landscape.volumes[0].name + ".vdb";
  const fs::path volume = folder / "data/volumes" / name;
  fs::resize_file(volume, fs::file_size(volume) - 100);
  EXPECT_NE(rerun(), 0);
  EXPECT_NE(read_file(folder / "log").find(name + " is damaged"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "picture.png"));
}

}  // namespace
}  // namespace wold::blender
