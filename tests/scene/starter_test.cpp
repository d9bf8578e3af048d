#include "scene/starter.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/error.h"
#include "scene/parse.h"
#include "scene/species.h"
#include "scene/starter_at_place.h"
#include "scene/write.h"
#include "support/places.h"

namespace wold::scene {
namespace {

TEST(StarterScene, IsShortAndOfHillsInFlowerUnderClouds) {
  const Scene defaults;
  const std::string text = starter_scene("heath", "hillside");
  const Scene read = parse_scene(text, "heath.toml");
  EXPECT_EQ(read.name, "heath");
  EXPECT_EQ(read.clouds.size(), 1U);
  EXPECT_GT(read.terrain.size_m, 120.0);  // a large terrain: nothing on it has a size of its own
  EXPECT_GT(read.terrain.boulders_per_hectare, 0.0);
  EXPECT_EQ(read.paths.size(), 1U);
  EXPECT_EQ(read.sun, defaults.sun);
  EXPECT_EQ(read.ageing.frames, defaults.ageing.frames);
  ASSERT_GE(read.species.size(), 2U);
  EXPECT_EQ(read.species.front().plant, species_of(defaults)[0].plant);
  EXPECT_GT(read.species.back().flower.petals, 0);
  EXPECT_TRUE(std::ranges::any_of(
      read.species, [](const Species& species) { return species.plant.crown_m > 0.0; }));
  EXPECT_LT(text.size(), resolved_toml(read).size() / 2);
  EXPECT_THROW(starter_scene("a/b", "hillside"), InputError);
  EXPECT_THROW(starter_scene("", "hillside"), InputError);
  EXPECT_THROW(starter_scene("heath", "hill"), InputError);
}

TEST(StarterScene, OfHillsIsAnExample) {
  const std::filesystem::path file =
      wold::test::tests_folder().parent_path() / "examples" / "hill_path.toml";
  Scene wanted = scene_of_kind("hillside");
  wanted.name = "hill_path";
  EXPECT_EQ(resolved_toml(read_scene(file)), resolved_toml(wanted));
}

/// What a starter is of is written, and nothing is lost on the way.
TEST(StarterScene, OfEachKindShowsWhatItSays) {
  const auto read = [](const std::string& kind) {
    return parse_scene(starter_scene("a", kind), kind);
  };
  EXPECT_THAT(starter_kinds(),
              testing::ElementsAre("hillside", "mountain", "clouds", "snow", "season"));
  EXPECT_EQ(read("mountain").terrain.shape, TerrainShape::mountain);
  const Scene clouds = read("clouds");
  ASSERT_EQ(clouds.clouds.size(), 2U);
  EXPECT_EQ(clouds.clouds[1].speed_m_s, 25.0);
  EXPECT_EQ(clouds.cloud_events.at(0).duration_s, 60.0);
  // 2.5 mm of water an hour from the first frame to the last are ten centimetres of new snow, whose
  // density is about a tenth of water's.
  const Scene snow = read("snow");
  const double hours = snow.film.frame_seconds * (snow.ageing.frames.size() - 1.0) / 3600.0;
  EXPECT_NEAR(hours * snow.weather.precipitation_mm_h, 10.0, 1.0);
  EXPECT_LT(snow.weather.temperature_c, 0.0);
  const Scene season = read("season");
  ASSERT_EQ(season.season_keys.size(), 8U);
  EXPECT_EQ(season.season_keys[3].precipitation_mm_day, 6.0);
  EXPECT_FALSE(season.season_keys[3].weathering.has_value());
  EXPECT_EQ(season.season_keys.back().date, season.season.last);
  // A frame's sky is the mean of itself and of two to either side: it has not snowed in any of them
  // at the end, whose frames are three days apart.
  const SeasonKey& snow_ends = season.season_keys[6];
  EXPECT_EQ(snow_ends.precipitation_mm_day, 0.0);
  EXPECT_EQ(season.season_keys[7].precipitation_mm_day, 0.0);
  EXPECT_EQ(snow_ends.date[1], 11);
  EXPECT_LE(snow_ends.date[2], 30 + season.season.last[2] - 3 * 2);
}

/// A key that is not written has its default, whatever the kind wants.
TEST(StarterScene, OfEachKindHasAllOfItsKeys) {
  for (const std::string& kind : starter_kinds()) {
    Scene wanted = scene_of_kind(kind);
    wanted.name = "a";
    EXPECT_EQ(resolved_toml(parse_scene(starter_scene("a", kind), kind)), resolved_toml(wanted))
        << kind;
  }
}

/// A hill of the scene's own has no keys there, whatever the kind; all else stays.
TEST(StarterScene, OfARealPlaceShowsIt) {
  StarterPlace place{.elevation = "alps.tif",
                     .system = "EPSG:4326",
                     .size_m = 9000.0,
                     .samples = 301,
                     .visual_range_m = 30e3,
                     .eye_m = {4000.0, 3000.0},
                     .target_m = {4100.0, 3900.0},
                     .eye_height_m = 1.7,
                     .target_height_m = 20.0};
  for (const std::string& kind : starter_kinds()) {
    const std::string text = starter_scene("a", kind, place);
    for (const char* key :
         {"hill_height", "shape", "relief", "streams", "talus", "boulders", "grazing_steps"})
      EXPECT_EQ(text.find(std::string("\n") + key), std::string::npos) << kind;
    Scene wanted = scene_of_kind(kind);
    wanted.name = "a";
    wanted.terrain = {};
    wanted.paths = {};
    wanted.terrain.elevation = place.elevation;
    wanted.terrain.system = place.system;
    wanted.terrain.size_m = place.size_m;
    wanted.terrain.samples = place.samples;
    wanted.sky.visual_range_m = place.visual_range_m;
    wanted.camera.eye_m = place.eye_m;
    wanted.camera.eye_height_m = place.eye_height_m;
    wanted.camera.target_m = place.target_m;
    wanted.camera.target_height_m = place.target_height_m;
    Scene read = parse_scene(text, "a.toml");
    wanted.grass.variants = 2;
    wanted.species = at_place({kind, "", scene_of_kind(kind), {}}, place).scene.species;
    EXPECT_THAT(read.terrain.elevation, testing::EndsWith(place.elevation));
    read.terrain.elevation = place.elevation;
    EXPECT_EQ(resolved_toml(read), resolved_toml(wanted)) << kind;
  }
}

/// Grass of three tones, bushes that stay green among it, and flowers.
TEST(StarterScene, OfARealPlaceIsNoLawn) {
  const std::vector<Species> plants =
      at_place({"hillside", "", scene_of_kind("hillside"), {}}, {}).scene.species;
  const auto& grass = plants.front();
  EXPECT_EQ(grass.share, 1.0);
  EXPECT_EQ(grass.habitat.cover, 1.0) << "no bare ground where nothing else stands";
  const auto how_many = [&](const auto& are) { return std::ranges::count_if(plants, are); };
  EXPECT_EQ(how_many([](const Species& one) { return one.plant.crown_m > 0.0; }), 1);
  EXPECT_EQ(how_many([](const Species& one) { return one.flower.petals > 0; }), 1);
  const auto paler = [](double factor) {
    return [=](const Species& one) {
      return one.plant.crown_m == 0.0 && one.physiology.chlorophyll_ug_cm2 < 22.0 * factor;
    };
  };
  EXPECT_EQ(how_many(paler(0.6)), 1);
  EXPECT_EQ(how_many(paler(1.5)) + 1, how_many(paler(10.0))) << "one is darker";
  EXPECT_EQ(how_many([](const Species& one) { return one.habitat.driest > 0.0; }), 1);
}

/// It is as late in the day as in the Alps, 8 degrees east, and as late in the year.
TEST(StarterScene, OfAPlaceFarAwayHasItsSunAndItsSeason) {
  const auto season_at = [](double longitude_deg, double latitude_deg) {
    return scene_of_kind("season", std::array{longitude_deg, latitude_deg});
  };
  EXPECT_NEAR(season_at(8.0, 60.0).sun.time_h, 13.0, 1e-9);
  EXPECT_EQ(season_at(8.0, 60.0).season.first, scene_of_kind("season").season.first);
  EXPECT_NEAR(season_at(-172.0, 60.0).sun.time_h, 1.0, 1e-9) << "12 h later, of the day after";
  EXPECT_NEAR(season_at(173.0, 60.0).sun.time_h, 2.0, 1e-9);
  const Scene south = season_at(170.0, -44.0);
  EXPECT_EQ(south.season.first, (std::vector<std::int64_t>{2027, 2, 23}));
  EXPECT_EQ(south.season_keys.front().date, south.season.first);
  EXPECT_EQ(south.season_keys.back().date, south.season.last);
}

}  // namespace
}  // namespace wold::scene
