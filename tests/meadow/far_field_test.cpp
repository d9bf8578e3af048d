#include "meadow/far_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vdb.h"
#include "core/vdb_file.h"
#include "ground/haze.h"
#include "meadow/cells.h"
#include "support/film_parts.h"
#include "support/grown.h"
#include "support/temporary_folder.h"

namespace wold::meadow {
namespace {

constexpr float extinction = 3.0F;
const glm::vec3 source(0.02F, 0.04F, 0.01F);

/// A patch of 0.6 m filled 0.4 m high with a glowing fog: even, or walls of it across x (0) or y
/// (1), `wall` of every 10 voxels thick.
landscape::Volume fog_of_walls(const std::filesystem::path& folder, int wall, int across = 0) {
  auto density = openvdb::FloatGrid::create(0.0F);
  auto emission = openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F));
  density->setName("density");
  emission->setName("emission_q0");
  for (int first = 1; first <= 30; first += 10) {
    openvdb::CoordBBox box(openvdb::Coord(1), openvdb::Coord(30, 30, 20));
    box.min()[across] = first;
    box.max()[across] = first + wall - 1;
    density->fill(box, extinction);
    emission->fill(box, openvdb::Vec3s(source.x, source.y, source.z));
  }
  landscape::Volume volume;
  volume.vdb = folder / "fog.vdb";
  volume.emission_grid = "emission_q0";
  volume.voxels = {30, 30, 20};
  volume.voxel_m = 0.02;
  write_vdb(volume.vdb, {density, emission});
  return volume;
}

landscape::Volume even_fog(const std::filesystem::path& folder) { return fog_of_walls(folder, 10); }

/// Beer and Lambert.
double through(double length_m) { return std::exp(-double{extinction} * length_m); }

TEST(PatchAppearance, FollowsBeerAndLambert) {
  const test::TemporaryFolder folder("patch_look");
  const landscape::Volume fog = even_fog(folder.path());
  const PatchAppearance look(std::span(&fog, 1));
  for (const double elevation_deg : {90.0, 40.0, 25.0, 8.0}) {
    const double elevation = elevation_deg * 3.14159265358979 / 180.0;
    const landscape::AggregateAppearance seen =
        look.along({std::cos(elevation), 0.0, -std::sin(elevation)});
    const double wanted = through(0.4 / std::sin(elevation));
    EXPECT_NEAR(seen.transmittance, wanted, 0.03 * wanted + 0.001) << elevation_deg;
    EXPECT_NEAR(seen.radiance.g, double{source.g} * (1.0 - wanted), 0.01 * double{source.g});
  }
}

// Along walls a fifth of the rays goes through nothing but fog; across them each meets some.
TEST(PatchAppearance, IsThatFromItsAzimuth) {
  const test::TemporaryFolder folder("walls");
  const double elevation = 25.0 * 3.14159265358979 / 180.0;
  const double way_m = 0.4 / std::sin(elevation);
  for (const int across : {0, 1}) {
    const landscape::Volume walls = fog_of_walls(folder.path(), 2, across);
    const PatchAppearance look(std::span(&walls, 1));
    for (const double sign : {-1.0, 1.0}) {
      glm::dvec3 direction(0.0, 0.0, -std::sin(elevation));
      direction[across] = sign * std::cos(elevation);
      EXPECT_NEAR(look.along(direction).transmittance, through(0.2 * way_m), 0.025);
      std::swap(direction.x, direction.y);
      EXPECT_NEAR(look.along(direction).transmittance, 0.8 + 0.2 * through(way_m), 0.025);
    }
  }
}

TEST(PatchAppearance, ThickenedTwiceIsTwoLayers) {
  const landscape::AggregateAppearance once{glm::dvec3(0.3), 0.4};
  const landscape::AggregateAppearance twice = thickened(once, 2.0);
  EXPECT_NEAR(twice.transmittance, 0.16, 1e-12);
  EXPECT_NEAR(twice.radiance.r, 0.3 + 0.4 * 0.3, 1e-12);
  EXPECT_EQ(thickened({glm::dvec3(0.0), 1.0}, 3.0).transmittance, 1.0);
}

/// Level ground 400 m wide, looked over from a tower: near and far in one picture.
scene::Scene plain_scene() {
  scene::Scene scene;
  scene.terrain.size_m = 400.0;
  scene.camera.eye_m = {200.0, 1.0};
  scene.camera.eye_height_m = 20.0;
  scene.camera.target_m = {200.0, 150.0};
  return scene;
}

// Where grass no longer stands it is painted, and nowhere less than all of it is there.
TEST(FarField, TakesOverWhatStandsNoLonger) {
  const scene::Scene scene = plain_scene();
  const Heightfield ground(41, 400.0);
  const place::View view(place::resolved_camera(scene.camera, ground, 0.0), 960, 540);
  ASSERT_TRUE(has_far_field(scene, ground, view));
  const FactorMap extinction_factor =
      grass_extinction_factor(scene, ground, FactorMap(801, 400.0, 1.0F), view);
  EXPECT_EQ(extinction_factor.sample(200.0, 60.0), 1.0F);
  EXPECT_EQ(extinction_factor.sample(200.0, 390.0), 0.0F);
  double farthest_m = 0.0;
  for (const CellChoice& cell :
       choose_cells(scene, ground, test::grown(scene), test::mixtures_of(scene, ground),
                    test::withering_of(scene, ground), test::grass_of(scene, 1)))
    farthest_m = std::max(farthest_m, cell.cell.y * scene.grass.patch_m);
  for (double y_m = 60.0; y_m < 390.0; y_m += 10.0) {
    const double fraction = far_fraction(scene.grass, view, {200.0, y_m, 0.0});
    EXPECT_NEAR(double{extinction_factor.sample(200.0, y_m)}, 1.0 - fraction, 0.01);
    if (fraction < 0.99) {
      EXPECT_GT(farthest_m, y_m - 1.0);
    }
  }
}

// The painted ground is what the volume would show: fog over a ground that glows faintly.
TEST(FarField, ShowsWhatTheVolumeWouldShow) {
  const test::TemporaryFolder folder("far_field");
  const landscape::Volume fog = even_fog(folder.path());
  scene::Scene scene = plain_scene();
  const Heightfield flat(41, 400.0);
  const place::View view(place::resolved_camera(scene.camera, flat, 0.0), 960, 540);
  PatchAppearances looks;
  for (const grass::PatchState& state :
       far_states(scene, test::withering_of(scene, flat), test::grass_of(scene, 2)))
    looks.emplace(std::pair(0, state), std::span(&fog, 1));
  const glm::vec3 bare(0.005F);
  ColourMap ground(401, 400.0, bare);
  const ColourMap light(2, 400.0, glm::vec3(0.8F));
  paint_far_grass(ground, scene, flat, test::grown(scene), light, view,
                  Meadow(scene, flat, test::mixtures_of(scene, flat),
                         test::withering_of(scene, flat), view, test::grass_of(scene, 2), looks));
  const double sine = 20.0 / std::hypot(20.0, 389.0);
  const double left = through(0.4 / sine);
  EXPECT_NEAR(ground.sample(200.0, 390.0).g, 0.8 * double{source.g} * (1.0 - left) + 0.005 * left,
              1e-4);
  EXPECT_EQ(ground.sample(200.0, 60.0), bare);
}

// Seen along its leaning blades, a meadow looks as upright grass does from above, through as much
// more of it as the way is longer.
TEST(FarField, LeansAsTheGrassDoes) {
  const test::TemporaryFolder folder("leaning");
  const landscape::Volume walls = fog_of_walls(folder.path(), 2);
  scene::Scene scene = plain_scene();
  scene.wind.heading_deg = 90.0;
  scene.wind.lean_deg = 20.0;
  const Heightfield flat(41, 400.0);
  const glm::dvec3 at_m(200.0, 150.0, 0.0);
  const glm::dvec2 lean = test::grass_of(scene, 2).wind_lean.lean(glm::dvec2(at_m));
  ASSERT_GT(std::abs(lean.x), 0.2);
  const place::MixtureField mixtures = test::mixtures_of(scene, flat);
  const place::Withering withering = test::withering_of(scene, flat);
  PatchAppearances looks;
  for (const grass::PatchState& state : far_states(scene, withering, test::grass_of(scene, 2)))
    looks.emplace(std::pair(0, state), std::span(&walls, 1));
  const auto seen = [&](double sign) {
    const place::View view({at_m + 30.0 * glm::dvec3(sign * lean, 1.0), at_m, 55.0}, 960, 540);
    return Meadow(scene, flat, mixtures, withering, view, test::grass_of(scene, 2), looks)
        .look(at_m)
        .transmittance;
  };
  const double from_above =
      PatchAppearance(std::span(&walls, 1)).along({0.0, 0.0, -1.0}).transmittance;
  EXPECT_NEAR(seen(1.0), std::pow(from_above, std::sqrt(1.0 + glm::dot(lean, lean))), 1e-6);
  EXPECT_LT(seen(-1.0), seen(1.0) - 0.02);
}

// Far grass is of the mixture that stands there: fog where the second species is, and nothing where
// it is not.
TEST(FarField, ShowsTheMixtureOfThePlace) {
  const test::TemporaryFolder folder("far_mixtures");
  const landscape::Volume fog = even_fog(folder.path());
  scene::Scene scene = plain_scene();
  scene.species.resize(2);
  scene.species[1].habitat.cover = 0.5;
  scene.species[1].habitat.feature_m = 20.0;
  const Heightfield flat(41, 400.0);
  const place::View view(place::resolved_camera(scene.camera, flat, 0.0), 960, 540);
  const place::MixtureField mixtures = test::mixtures_of(scene, flat);
  const place::Withering withering = test::withering_of(scene, flat);
  ASSERT_EQ(mixtures.present(), (std::vector<int>{0, 1}));
  PatchAppearances looks;
  for (const grass::PatchState& state : far_states(scene, withering, test::grass_of(scene, 2))) {
    looks.emplace(std::pair(0, state), std::span(&fog, 1));
    looks.emplace(std::pair(1, state), std::span<const landscape::Volume>());
  }
  const Meadow meadow(scene, flat, mixtures, withering, view, test::grass_of(scene, 2), looks);
  int with = 0;
  for (int k = 0; k < 100; ++k) {
    const glm::dvec3 at_m(110.0 + 20.0 * (k % 10), 200.0 + 18.0 * (k / 10), 0.0);
    const bool grows = mixtures.at(glm::dvec2(at_m)) == 0;
    EXPECT_EQ(meadow.look(at_m).radiance.g > 0.1 * double{source.g}, grows);
    with += grows;
  }
  EXPECT_GT(with, 20);
  EXPECT_LT(with, 80);
}

// At a quarter of the visual range haze hides 1 - 0.02^(1/4) and puts its own light there; grass
// that stands gets the light that makes it look so.
TEST(Haze, FollowsKoschmieder) {
  const test::TemporaryFolder folder("haze");
  const landscape::Volume fog = even_fog(folder.path());
  scene::Scene scene = plain_scene();
  scene.sky.visual_range_m = 1200.0;
  const Heightfield flat(41, 400.0);
  const landscape::Camera camera = place::resolved_camera(scene.camera, flat, 0.0);
  const place::View view(camera, 960, 540);
  const light::Daylight day(scene.sun, scene.sky);
  const ground::Haze haze(day, camera.eye_m);
  EXPECT_TRUE(ground::shows_haze(flat, camera.eye_m, 1200.0));
  EXPECT_FALSE(ground::shows_haze(flat, camera.eye_m, 1e6));
  const glm::dvec3 at_m = camera.eye_m + glm::dvec3(0.0, 300.0, 0.0);
  const double left = std::pow(0.02, 0.25);
  const glm::vec3 seen = haze.before(glm::vec3(0.0F), at_m);
  EXPECT_NEAR(haze.before(glm::vec3(1.0F), at_m).g - seen.g, left, 2e-3);
  const glm::vec3 air = day.haze_radiance({0.0, 1.0, 0.0}, 1.0 - left);
  EXPECT_NEAR(seen.g, (1.0 - left) * double{air.g}, 2e-3);
  PatchAppearances looks;
  for (const grass::PatchState& state :
       far_states(scene, test::withering_of(scene, flat), test::grass_of(scene, 2)))
    looks.emplace(std::pair(0, state), std::span(&fog, 1));
  const place::MixtureField mixtures = test::mixtures_of(scene, flat);
  const place::Withering withering = test::withering_of(scene, flat);
  const Meadow meadow(scene, flat, mixtures, withering, view, test::grass_of(scene, 2), looks);
  const ColourMap light(401, 400.0, glm::vec3(0.8F));
  const glm::dvec3 far_m(200.0, 300.0, 0.0);
  const float factor =
      ground::veil_of_grass(light, flat, view, meadow, haze).sample(far_m.x, far_m.y).g;
  const landscape::AggregateAppearance look = meadow.look(far_m);
  const auto grass = static_cast<float>(0.8 * look.radiance.g / (1.0 - look.transmittance));
  EXPECT_NEAR(factor * grass, haze.before(glm::vec3(grass), far_m).g, 1e-4F);
}

// Blades per square metre of a slope, not of its shadow at noon.
TEST(FarField, SlopesKeepTheDensityPerSquareMetre) {
  scene::Scene scene = plain_scene();
  scene.terrain.size_m = 20.0;
  scene.camera.eye_m = {10.0, 0.0};
  scene.camera.target_m = {10.0, 10.0};
  Heightfield slope(41, 20.0);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) slope.at(i, j) = static_cast<float>(0.75 * j * 0.5);
  const place::View view(place::resolved_camera(scene.camera, slope, 0.0), 960, 540);
  const FactorMap extinction_factor =
      grass_extinction_factor(scene, slope, FactorMap(41, 20.0, 1.0F), view);
  EXPECT_NEAR(extinction_factor.sample(10.0, 10.0), 1.25F,
              1e-4F);  // a slope of 3 in 4: cosine 4 / 5
}

}  // namespace
}  // namespace wold::meadow
