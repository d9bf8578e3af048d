#include "film/assemble.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/statistics.h"
#include "film/exporters.h"
#include "meadow/tint.h"
#include "phenology/film_season.h"
#include "place/ground_grids.h"
#include "scene/key_frames.h"
#include "scene/species.h"
#include "sky/exposure.h"
#include "support/film_parts.h"
#include "support/grown.h"
#include "support/no_grass.h"
#include "terrain/hillside.h"

namespace wold::film {
namespace {

using test::grown;

scene::Scene small_meadow() {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.grass.patch_m = 0.5;
  scene.terrain.samples = 65;
  scene.terrain.hill_height_m = 1.0;
  scene.camera.eye_m = {4.0, 0.5};
  scene.camera.target_m = {4.0, 6.0};
  return scene;
}

/// A tube in the middle of each of the smallest parts of a patch of half a metre.
landscape::BladeMesh tube_in_each_part(const std::string& name) {
  Tubes tubes{1, 1, {}, {}};
  for (int k = 0; k < 64; ++k) {
    const glm::vec2 eighths = glm::vec2(k % 8, k / 8) + 0.5F;
    tubes.vertices_m.emplace_back(eighths / 16.0F, 0.0F);
    tubes.radiance.emplace_back(1.0F);
  }
  return {name, std::make_shared<const Tubes>(std::move(tubes))};
}

TEST(Assemble, CellsReferToTheirVolumes) {
  const scene::Scene scene = small_meadow();
  const place::Site site = test::site_of(scene);
  const Heightfield& terrain = site.terrain;
  const std::vector<meadow::CellChoice> choices =
      meadow::choose_cells(scene, terrain, site.growth, test::mixtures_of(scene, terrain),
                           test::withering_of(scene, terrain), test::grass_of(scene, 2));
  const auto name = [](const meadow::CellChoice& c) {
    return std::to_string(c.variant) + "/" + std::to_string(c.key_frame) + "/" +
           std::to_string(c.turn) + "/" + std::to_string(c.lod);
  };
  const landscape::Landscape landscape = assemble(
      scene, site, test::grass_of(scene, 2), choices,
      {[&](const meadow::CellChoice& choice) {
         landscape::Volume volume;
         volume.name = name(choice);
         volume.voxels = glm::ivec3(30);  // not fine
         return volume;
       },
       [](const meadow::CellChoice&) { return landscape::BladeMesh{}; }, test::no_grass().far},
      needs_of({}));
  std::set<std::string> names;
  for (const landscape::Volume& volume : landscape.volumes)
    EXPECT_TRUE(names.insert(volume.name).second);
  auto cell = landscape.cells.begin();
  for (const meadow::CellChoice& choice : choices)
    for (const landscape::PlacedPart& placed : choice.parts) {
      ASSERT_NE(cell, landscape.cells.end());
      EXPECT_EQ(landscape.volumes[static_cast<std::size_t>(cell->volume)].name, name(choice));
      EXPECT_EQ(cell->part, placed.part);
      EXPECT_EQ(cell++->world_from_cell, placed.world_from_cell);
    }
  EXPECT_EQ(cell, landscape.cells.end());
  EXPECT_GT(landscape.cells.size(), choices.size());
  EXPECT_EQ(landscape.weathering, 0.30);
  EXPECT_EQ(landscape.exposure_gain, 1.6 * std::numbers::pi);
  EXPECT_NEAR(landscape.camera.eye_m.z, terrain.sample(4.0, 0.5) + 1.6, 1e-6);
  EXPECT_NEAR(landscape.camera.target_m.z, terrain.sample(4.0, 6.0) + 0.5, 1e-6);
}

// The camera of a season opens when clouds hide the winter sun, so that snow stays white.
TEST(Assemble, ExposesSnowUnderCloudsAsInTheSun) {
  scene::Scene scene = small_meadow();
  scene.season.first = {2026, 12, 1};
  scene.season.last = {2026, 12, 3};
  scene.season.frames = 3;
  scene.season_keys = {{.date = {2026, 12, 1}, .weathering = 1.0, .temperature_c = -8.0}};
  scene.sun.latitude_deg = 46.5;
  scene.sun.time_h = 12.0;
  scene.snow_cover.initial_mm = 60.0;
  const auto shown = [](const scene::Scene& described) {
    const scene::Scene film = test::film_of(described);
    const place::Site site = test::site_of(film);
    return assemble(film, place::site_of_frame(film, site, 2), test::grass_of(film, 2), {},
                    test::no_grass(), needs_of({}));
  };
  const auto mean_shown = [](const landscape::Landscape& landscape) {
    double sum = 0.0;
    for (const glm::vec3& radiance : landscape.ground.values()) sum += double{radiance.g};
    return landscape.exposure_gain * sum / static_cast<double>(landscape.ground.values().size());
  };
  const landscape::Landscape clear = shown(scene);
  scene.clouds.resize(1);
  scene.clouds[0].kind = scene::CloudKind::stratus;
  scene.clouds[0].cover = 2.0;  // without thin places
  const landscape::Landscape clouded = shown(scene);
  const double of_card = 0.95 * std::numbers::pi;  // white, on level ground in the open
  EXPECT_LT(clear.exposure_gain, 0.8 * of_card);   // slopes face the low sun
  EXPECT_NEAR(clouded.exposure_gain, of_card, 1e-6);
  EXPECT_LT(mean_shown(clouded), mean_shown(clear));  // it is dim nevertheless
  EXPECT_GT(mean_shown(clouded), 0.5 * mean_shown(clear));
}

// As the sun sinks pictures get darker, by half the stops that the light loses: on a clear day the
// ground has about a tenth of the light at 3 degrees that it has at 20 (a tenth to a fifteenth is
// measured: 20 to 30 klx and 2 to 3 klx).
TEST(Assemble, DuskIsDarkerThanDay) {
  scene::Scene scene = small_meadow();
  scene.ageing.frames = {0.0, 0.0};
  scene.sun.elevation_deg = 20.0;
  scene.sun.end = {3.0, scene.sun.azimuth_deg};
  const place::Site site = test::site_of(scene);
  const auto relative_gain = [&](int frame) {
    const place::Site now = place::site_of_frame(scene, site, frame);
    return assemble(scene, now, test::grass_of(scene, frame), {}, test::no_grass(), needs_of({}))
               .exposure_gain /
           sky::metered_gain(now.day, sky::Subject::meadow);
  };
  EXPECT_NEAR(relative_gain(1), 1.0, 1e-9);
  EXPECT_GT(relative_gain(2), std::sqrt(1.0 / 20.0));
  EXPECT_LT(relative_gain(2), std::sqrt(1.0 / 6.0));
}

// After sunset the ground has the sky's light and no other, and a picture can be made of it.
TEST(Assemble, HasTheLightOfDusk) {
  for (const double elevation_deg : {0.0, -2.0, -4.0}) {
    scene::Scene scene = small_meadow();
    scene.sun.elevation_deg = elevation_deg;
    scene.clouds.resize(1);
    const place::Site site = test::site_of(scene);
    const landscape::Landscape landscape =
        assemble(scene, site, test::grass_of(scene, 2), {}, test::no_grass(), needs_of({}));
    EXPECT_LE(landscape.daylight.sun_irradiance.r, elevation_deg < 0.0 ? 0.0F : 0.1F);
    EXPECT_GT(landscape.exposure_gain, 0.3);
    EXPECT_LT(landscape.exposure_gain, 3.0);
    for (const ColourMap* map : {&landscape.ground, &landscape.light})
      for (const glm::vec3& value : map->values())
        for (int c = 0; c < 3; ++c) {
          ASSERT_TRUE(std::isfinite(value[c]));
          ASSERT_GE(value[c], 0.0F);
        }
    for (const float value : landscape.sky.values) ASSERT_TRUE(std::isfinite(value));
  }
}

// With a low sun the sky is exposed, not the ground.
TEST(Assemble, DoesNotBurnOutTheSkyOfAnEvening) {
  scene::Scene scene = small_meadow();
  scene.sun.elevation_deg = 4.0;
  const place::Site site = test::site_of(scene);
  const landscape::Landscape landscape =
      assemble(scene, site, test::grass_of(scene, 2), {}, test::no_grass(), needs_of({}));
  const glm::vec3 sky = site.day.mean_sky_radiance(20.0 * std::numbers::pi / 180.0);
  const double luminance = 0.2126 * double{sky.r} + 0.7152 * double{sky.g} + 0.0722 * double{sky.b};
  EXPECT_NEAR(landscape.exposure_gain * luminance, 0.9, 1e-4);
}

landscape::Landscape in_a_storm(double snow_mm, double hill_m = 1.0) {
  scene::Scene scene = small_meadow();
  scene.snow_cover.initial_mm = snow_mm;
  scene.weather.temperature_c = -8.0;
  scene.wind.speed_m_s = 16.0;
  scene.terrain.hill_height_m = hill_m;
  scene.sun.elevation_deg = 6.0;
  scene.sun.azimuth_deg = 0.0;  // behind the hill
  const place::Site site = test::site_of(scene);
  return assemble(scene, site, test::grass_of(scene, 2), {}, test::no_grass(), needs_of({}));
}

/// Sum of extinctions, and of what they send.
glm::dvec2 blown(const landscape::Landscape& landscape) {
  glm::dvec2 sum(0.0);
  for (const landscape::CloudBox& box : landscape.clouds)
    for (std::size_t i = 0; i < box.radiance.size(); ++i)
      sum += double{box.extinction_per_m[i]} * glm::dvec2(1.0, box.radiance[i].g);
  return sum;
}

// Plants hold the snow that they stand out of (Liston and Sturm 1998).
TEST(Assemble, StormsLiftSnowWhereNoGrassStandsOutOfIt) {
  const double deep = blown(in_a_storm(200.0)).x;
  EXPECT_GT(deep, 0.0);
  EXPECT_LT(blown(in_a_storm(4.0)).x, 0.1 * deep);
}

TEST(Assemble, SnowThatBlowsInTheShadeOfAHillIsDark) {
  const glm::dvec2 shaded = blown(in_a_storm(200.0, 4.0)), lit = blown(in_a_storm(200.0, 0.0));
  EXPECT_LT(shaded.y / shaded.x, 0.8 * lit.y / lit.x);
}

// Every cell is drawn once, as a volume or as blades; meshes are shared by turns and levels.
TEST(Assemble, CellsOfBladesReferToTheirMeshes) {
  scene::Scene scene = small_meadow();
  scene.render.size_px = {960, 540};  // blades stand only where they are seen as such
  scene.render.grass = scene::GrassForm::automatic;
  scene.grass.pixels_per_voxel = 0.4;
  const place::Site site = test::site_of(scene);
  const std::vector<meadow::CellChoice> choices = meadow::choose_cells(
      scene, site.terrain, site.growth, *site.mixtures, *site.withering, test::grass_of(scene, 2));
  const landscape::Landscape landscape =
      assemble(scene, site, test::grass_of(scene, 2), choices,
               {[](const meadow::CellChoice&) { return landscape::Volume{}; },
                [](const meadow::CellChoice& choice) {
                  return tube_in_each_part(std::to_string(choice.variant * 100 + choice.key_frame));
                },
                test::no_grass().far},
               needs_of({}));
  std::size_t parts = 0;
  for (const meadow::CellChoice& choice : choices) parts += choice.parts.size();
  EXPECT_EQ(landscape.cells.size() + landscape.blade_cells.size(), parts);
  ASSERT_FALSE(landscape.cells.empty());
  ASSERT_FALSE(landscape.blade_cells.empty());
  std::set<std::string> names;
  for (const landscape::BladeMesh& mesh : landscape.blade_meshes)
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
  auto cell = landscape.blade_cells.begin();
  for (const meadow::CellChoice& choice : choices) {
    if (!choice.blades) continue;
    for (const landscape::PlacedPart& placed : choice.parts) {
      EXPECT_EQ(landscape.blade_meshes[static_cast<std::size_t>(cell->mesh)].name,
                std::to_string(choice.variant * 100 + choice.key_frame) +
                    landscape::suffix_of(placed.part));
      EXPECT_EQ(cell++->world_from_cell, placed.world_from_cell);
    }
  }
}

// Nothing stands on three quarters of a patch with one blade.
TEST(Assemble, PartsWithoutBladesAreNotDrawn) {
  scene::Scene scene = small_meadow();
  scene.render.grass = scene::GrassForm::blades;
  const place::Site site = test::site_of(scene);
  const std::vector<meadow::CellChoice> choices = meadow::choose_cells(
      scene, site.terrain, site.growth, *site.mixtures, *site.withering, test::grass_of(scene, 2));
  auto tubes = std::make_shared<Tubes>(Tubes{1, 1, {glm::vec3(0.01F)}, {glm::vec3(1.0F)}});
  const landscape::Landscape landscape =
      assemble(scene, site, test::grass_of(scene, 2), choices,
               {{},
                [&](const meadow::CellChoice& choice) {
                  return landscape::BladeMesh{
                      std::to_string(choice.variant * 100 + choice.key_frame), tubes};
                },
                test::no_grass().far},
               needs_of({}));
  EXPECT_EQ(landscape.blade_cells.size(), choices.size());
  std::vector<bool> used(landscape.blade_meshes.size(), false);
  for (const landscape::BladeCell& cell : landscape.blade_cells)
    used.at(static_cast<std::size_t>(cell.mesh)) = true;
  EXPECT_EQ(std::ranges::count(used, false), 0);
}

TEST(WeatheringTint, RestoresTheWantedColour) {
  const scene::Scene scene = small_meadow();
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  const place::MixtureField mixtures = test::mixtures_of(scene, terrain);
  const place::Withering withering = test::withering_of(scene, terrain);
  const std::vector<meadow::CellChoice> choices = meadow::choose_cells(
      scene, terrain, grown(scene), mixtures, withering, test::grass_of(scene, 2));
  const meadow::GrassColour colour = [](double degree, double) {
    return glm::vec3(0.2, 0.3, 0.1) * static_cast<float>(1.0 + degree);
  };
  const ColourMap tint = meadow::weathering_tint(scene, withering, 2, choices, /*snow=*/0.0, colour,
                                                 place::tint_grid(scene));
  for (const meadow::CellChoice& choice : choices) {
    const glm::dvec2 centre_m = (glm::dvec2(choice.cell) + 0.5) * scene.grass.patch_m;
    const double shown = scene::key_frames(scene)[static_cast<std::size_t>(choice.key_frame)];
    const glm::vec3 got = tint.sample(centre_m.x, centre_m.y) * colour(shown, 0.0);
    EXPECT_NEAR(got.g, colour(withering.at(centre_m, 2), 0.0).g, 1e-5);
  }
  const ColourMap light = product(ColourMap(5, 8.0, glm::vec3(2.0F)), tint);
  EXPECT_EQ(light.samples(), tint.samples());
  EXPECT_EQ(light.at(40, 40), tint.at(40, 40) * 2.0F);
}

/// How red the light on the grass of the last frame is, beside green: where it is least, in the
/// mean and where it is most.
std::array<float, 3> redness(const scene::Scene& scene) {
  constexpr int frame = 3;
  const place::Site site = test::site_of(scene);
  const meadow::FrameGrass now = test::grass_of(scene, frame);
  const std::vector<meadow::CellChoice> choices =
      meadow::choose_cells(scene, site.terrain, site.growth, *site.mixtures, *site.withering, now);
  const ColourMap light = assemble(scene, site, now, choices, test::no_grass(), needs_of({})).light;
  std::vector<float> red;
  for (const glm::vec3& value : light.values()) red.push_back(value.r / value.g);
  std::ranges::sort(red);
  return {red[red.size() / 50], static_cast<float>(mean(red)), red[red.size() - red.size() / 50]};
}

// Evergreen shrubs are not what grass withers like, nor what light reaches it through.
TEST(Assemble, ShrubsThatGrowNowhereDoNotColourGrass) {
  scene::Scene scene = small_meadow();
  const std::array<float, 3> alone = redness(scene);
  scene.species = {scene::species_of(scene).front(), scene::species_of(scene).front()};
  scene::Species& shrub = scene.species[1];
  shrub.name = "shrub";
  shrub.share = 20.0;
  shrub.habitat.steepest_deg = 0.0;
  shrub.plant.crown_m = 0.4;
  shrub.plant.mingle = {{"evergreen", {}}};
  const std::array<float, 3> beside = redness(scene);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(beside[k], alone[k], 0.025F) << k;
}

TEST(LeafAreaIndex, IsThatOfTaperingBlades) {
  scene::Scene scene;  // 900 blades of 1 m x 0.01 m halved, on 1.5 m2
  scene.grass.patch_m = std::sqrt(1.5);
  scene.grass.blades = 900;
  scene.grass.height_m = 1.0;
  scene.grass.width_m = 0.01;
  EXPECT_NEAR(place::leaf_area_index(scene), 3.0, 1e-5);
}

TEST(Assemble, HasTheBouldersOfItsSite) {
  scene::Scene scene = small_meadow();
  const auto boulders = [&] {
    return assemble(scene, test::site_of(scene), test::grass_of(scene, 1), {}, test::no_grass(),
                    needs_of({}))
        .boulders.triangles.size();
  };
  EXPECT_EQ(boulders(), 0U);
  scene.terrain.boulders_per_hectare = 200.0;
  EXPECT_GT(boulders(), 0U);
}

}  // namespace
}  // namespace wold::film
