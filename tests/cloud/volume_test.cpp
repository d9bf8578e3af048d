#include <gtest/gtest.h>

#include <numbers>

#include "cloud/lifting.h"
#include "cloud/optical_sweep.h"
#include "cloud/scattering.h"

namespace wold::cloud {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double pixel_m = 50.0;

CloudState one_volume(scene::CloudKind kind) {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].kind = kind;
  scene.clouds[0].body = scene::CloudBody::volume;
  scene.clouds[0].cell_m = 3200.0;
  scene.clouds[0].cells = {2, 2};
  return Clouds(scene, pixel_m).at(30.0);
}

CloudVolume lifted_period(const CloudState& state, const glm::ivec3& voxels) {
  return lifted(state.layers[0], pixel_m, {0.0, 0.0}, state.layers[0].layer->period_m, voxels);
}

TEST(Sweep, HasASlabsDepthsInClosedForm) {
  const VoxelBox box{{}, {10.0, 10.0, 5.0}, {16, 12, 20}, true};
  const std::vector<float> extinction(box.count(), 0.02F);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.7, -0.4, 0.5));
  const auto up = depth_towards(box, extinction, direction);
  const auto down = depth_towards(box, extinction, -direction);
  for (int z = 0; z < 20; ++z) {
    const std::size_t i = static_cast<std::size_t>(z) * 192 + 37;
    EXPECT_NEAR(up[i], 0.02 * (100.0 - (z + 0.5) * 5.0) / direction.z, 1e-4);
    EXPECT_NEAR(up[i] + down[i], 0.02 * 100.0 / direction.z, 1e-4);
  }
}

TEST(Sweep, ShadowsLieAwayFromTheSun) {
  const VoxelBox box{{}, {10.0, 10.0, 10.0}, {9, 9, 4}, false};
  std::vector<float> extinction(box.count());
  extinction[3 * 81 + 4 * 9 + 4] = 0.1F;  // one voxel of the top, in the middle
  const auto depth = depth_towards(box, extinction, glm::normalize(glm::dvec3(1.0, 0.0, 1.0)));
  const double whole = 0.1 * 10.0 * std::sqrt(2.0);
  EXPECT_NEAR(depth[2 * 81 + 4 * 9 + 3], 1.0 * whole, 1e-5);  // to the west, a voxel a plane
  EXPECT_NEAR(depth[1 * 81 + 4 * 9 + 2], 1.0 * whole, 1e-5);
  EXPECT_EQ(depth[1 * 81 + 4 * 9 + 4], 0.0F);
}

TEST(Volume, ColumnsHaveTheLayersDroplets) {
  for (const scene::CloudKind kind : {scene::CloudKind::stratus, scene::CloudKind::cirrus}) {
    const CloudState state = one_volume(kind);
    const CloudVolume volume = lifted_period(state, {64, 64, 16});
    EXPECT_TRUE(volume.box.repeats);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        double depth = 0.0;
        for (int z = 0; z < 16; ++z)
          depth += volume.box.voxel_m.z *
                   static_cast<double>(
                       volume.extinction_per_m[static_cast<std::size_t>((z * 64 + y) * 64 + x)]);
        const glm::dvec2 place((x + 0.5) * 100.0, (y + 0.5) * 100.0);
        const double wanted = droplets_per_seen(*state.layers[0].layer) *
                              optical_depth_at(state.layers[0], pixel_m, place);
        EXPECT_NEAR(depth, wanted, 1e-3);
      }
  }
}

TEST(Volume, IsOfALayerWithHeads) {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].kind = scene::CloudKind::cirrus;
  EXPECT_THROW(lifted_period(Clouds(scene, pixel_m).at(0.0), {8, 8, 8}), std::bad_optional_access);
}

// Heaps stand on a flat base, higher where the layer is deeper, and have the droplets' own
// extinction within some metres from their surface.
TEST(Volume, HeapsHaveAFlatBaseAndHigherTopsWhereTheLayerIsDeeper) {
  const CloudState state = one_volume(scene::CloudKind::cumulus);
  const Layer& layer = *state.layers[0].layer;
  const CloudVolume volume = lifted_period(state, {256, 256, 32});
  EXPECT_EQ(volume.box.corner_m.z, layer.base_m);
  const double densest = layer.seen_depth;
  std::array<double, 2> tops{}, columns{};  // of thin and of dense columns
  double lowest = 0.0, whole = 0.0, filled = 0.0;
  for (int column = 0; column < 256 * 256; ++column) {
    int top = -1, low = -1;
    for (int z = 0; z < 32; ++z) {
      const double extinction{
          volume.extinction_per_m[static_cast<std::size_t>(z * 256 * 256 + column)]};
      EXPECT_LE(extinction, 1.001 * layer.droplets.extinction_per_m);
      if (extinction <= 0.0) continue;
      top = z;
      if (low < 0) low = z;
      filled += 1.0;
      whole += extinction > 0.999 * layer.droplets.extinction_per_m;
    }
    if (top < 0) continue;
    const glm::dvec3 place = volume.box.centre_m({column % 256, column / 256, 0});
    const double depth = optical_depth_at(state.layers[0], pixel_m, glm::dvec2(place));
    const std::size_t dense = depth > 0.5 * densest ? 1 : 0;
    tops[dense] += top;
    columns[dense] += 1.0;
    lowest += low < 3;
  }
  EXPECT_GT(columns[0], 1000.0);
  EXPECT_GT(columns[1], 1000.0);
  EXPECT_GT(tops[1] / columns[1], 1.3 * tops[0] / columns[0]);
  EXPECT_GT(lowest, 0.8 * (columns[0] + columns[1]));
  EXPECT_GT(whole, 0.5 * filled);
}

TEST(Volume, DriftsWithItsLayer) {
  CloudState state = one_volume(scene::CloudKind::cumulus);
  state.layers[0].moment.way_m = {0.0, 0.0};
  const CloudVolume before = lifted_period(state, {64, 64, 16});
  state.layers[0].moment.way_m = {300.0, 0.0};  // three voxels
  const CloudVolume after = lifted_period(state, {64, 64, 16});
  for (int row = 0; row < 64 * 16; ++row)
    for (int x = 0; x < 64; ++x) {
      const auto at = [&](int column) { return static_cast<std::size_t>(row * 64 + column % 64); };
      EXPECT_NEAR(after.extinction_per_m[at(x + 3)], before.extinction_per_m[at(x)], 1e-3);
    }
}

/// A slab of droplets with the sun overhead.
CloudVolume slab(double depth) {
  CloudVolume volume;
  volume.box = {{0.0, 0.0, 1000.0}, {10.0, 10.0, 2.5}, {8, 8, 80}, true};
  volume.extinction_per_m.assign(volume.box.count(), static_cast<float>(depth / 200.0));
  return volume;
}

/// Radiance that leaves a column downwards, or upwards, by its source.
double radiance_out(const CloudVolume& volume, const std::vector<glm::vec3>& source, bool down) {
  double radiance = 0.0;
  for (int i = 0; i < volume.box.voxels.z; ++i) {
    const int z = down ? volume.box.voxels.z - 1 - i : i;
    const auto at = static_cast<std::size_t>(z) * 64 + 20;
    const double alpha =
        -std::expm1(-static_cast<double>(volume.extinction_per_m[at]) * volume.box.voxel_m.z);
    radiance += alpha * (static_cast<double>(source[at].g) - radiance);
  }
  return radiance;
}

TEST(Light, OfAThickSlabIsWhatTwoStreamReflectsAndLetsThrough) {
  const CloudVolume volume = slab(40.0);
  CloudLight light;
  light.sun_irradiance = glm::vec3(1.0F);
  const double reflected = two_stream(0.86, 0.0, 40.0).back;
  light.eye_m = {40.0, 40.0, -1e6};
  const double below = pi * radiance_out(volume, source_radiance(volume, light), true);
  light.eye_m = {40.0, 40.0, 1e6};
  const double above = pi * radiance_out(volume, source_radiance(volume, light), false);
  EXPECT_NEAR(below, 1.0 - reflected, 0.1);
  EXPECT_NEAR(above, reflected, 0.05);
  EXPECT_LT(below, 0.5 * above);  // dark bases
}

TEST(Light, MakesThinEdgesShineAroundTheSun) {
  const CloudVolume volume = slab(0.3);
  CloudLight light;
  light.sun_irradiance = glm::vec3(1.0F);
  light.eye_m = {40.0, 40.0, -1e6};  // looks up into the sun
  const double into_the_sun = radiance_out(volume, source_radiance(volume, light), true);
  light.eye_m = {40.0, 1e6, 1100.0};
  const double across = radiance_out(volume, source_radiance(volume, light), true);
  EXPECT_GT(into_the_sun, 20.0 * across);
  // Scattered once, twice, three times: the way in and the way out make up the whole depth.
  const auto peak = [](double g) { return henyey_greenstein(g, 1.0); };
  const double once = 0.3 * std::exp(-0.3) * peak(0.86);
  const double twice = 0.045 * std::exp(-0.3) * (peak(0.86 * 0.86) - 0.25 / pi);
  const double thrice = 0.0045 * std::exp(-0.3) * (peak(0.86 * 0.86 * 0.86) - 0.25 / pi);
  EXPECT_NEAR(into_the_sun, once + twice + thrice, 0.03);
}

/// A heap that stands alone: half a ball of 300 m, of droplets as heaps have them on average.
CloudVolume dome() {
  CloudVolume dome{{{-480.0, -480.0, 0.0}, {16.0, 16.0, 16.0}, {60, 60, 24}, false}, {}, 0.866};
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x)
        dome.extinction_per_m.push_back(glm::length(dome.box.centre_m({x, y, z})) < 300.0 ? 0.08F
                                                                                          : 0.0F);
  return dome;
}

CloudLight sun_and_sky(double elevation_rad, const glm::dvec3& eye_m) {
  CloudLight light;
  light.sun_direction = {std::cos(elevation_rad), 0.0, std::sin(elevation_rad)};
  light.sun_irradiance = glm::vec3(1.0F);
  light.sky_irradiance = glm::vec3(0.15F);
  light.ground_irradiance = glm::vec3(0.05F);
  light.eye_m = eye_m;
  light.surroundings = [](const glm::dvec3& direction) {
    return glm::vec3((direction.z > 0.0 ? 0.15F : 0.05F) / std::numbers::pi_v<float>);
  };
  return light;
}

std::vector<glm::vec3> source_by_depths(const CloudVolume& dome, const glm::dvec3& from_eye,
                                        const CloudLight& light) {
  const ForwardTable forward(forward_source, dome.asymmetry);
  const auto depth = [&](const glm::dvec3& way) {
    return depth_towards(dome.box, dome.extinction_per_m, way);
  };
  const auto to_sun = depth(light.sun_direction), from_sun = depth(-light.sun_direction),
             up = depth({0.0, 0.0, 1.0}), down = depth({0.0, 0.0, -1.0});
  std::vector<glm::vec3> source;
  for (std::size_t i = 0; i < dome.box.count(); ++i)
    source.push_back(source_at(
        forward, dome.asymmetry,
        {double{to_sun[i]}, double{from_sun[i]}, double{up[i]}, double{down[i]}}, from_eye, light));
  return source;
}

/// What a far eye sees of it, over all of its picture.
double seen(const CloudVolume& dome, const glm::dvec3& from_eye,
            const std::vector<glm::vec3>& source) {
  const auto before = depth_towards(dome.box, dome.extinction_per_m, -from_eye);
  double sum = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i)
    sum += double{dome.extinction_per_m[i]} * std::exp(-double{before[i]}) * double{source[i].g};
  return sum;
}

/// The law of heaps seen as sheets, which has the optical depths along four ways alone.
TEST(Light, OfAHeapByItsDepthsIsNearThatOfAllOrders) {
  const CloudVolume heap = dome();
  for (const double elevation_deg : {5.0, 20.0, 50.0})
    for (const glm::dvec3& from_eye :
         {glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0),
          glm::normalize(glm::dvec3(1.0, 0.0, 0.5)), glm::normalize(glm::dvec3(-1.0, 0.0, 0.5))}) {
      const CloudLight light = sun_and_sky(elevation_deg * pi / 180.0, -1e5 * from_eye);
      const double all_orders = seen(heap, from_eye, source_radiance(heap, light));
      const double by_depths = seen(heap, from_eye, source_by_depths(heap, from_eye, light));
      EXPECT_NEAR(by_depths / all_orders, 1.0, 0.35)
          << elevation_deg << " " << from_eye.x << " " << from_eye.y << " " << from_eye.z;
    }
}

TEST(Light, IsNeverNegativeOrEndless) {
  const CloudVolume volume = lifted_period(one_volume(scene::CloudKind::cumulus), {48, 48, 16});
  scene::Sun sun;
  for (const double elevation : {1.0, 20.0, 90.0}) {
    sun.elevation_deg = elevation;
    const light::Daylight day(sun, scene::Sky{});
    for (const glm::vec3& value : source_radiance(volume, cloud_light(day, 0.0, {0.0, 0.0, 2.0})))
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(value[c], 0.0F);
        EXPECT_LT(value[c], 10.0F * glm::max(1.0F, day.sun_irradiance()[c]));
      }
  }
}

}  // namespace
}  // namespace wold::cloud
