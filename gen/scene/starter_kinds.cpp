#include "scene/starter_kinds.h"

#include <cmath>

#include "scene/starter_plants.h"

namespace wold::scene {
namespace {

CloudLayer cumulus_layer(double cover) {
  CloudLayer layer;
  layer.kind = CloudKind::cumulus;
  layer.cover = cover;
  layer.heading_deg = 60.0;
  return layer;
}

/// Clouds of a fine day.
CloudLayer fair_weather() { return cumulus_layer(0.3); }

KeyNames keys_of_clouds() {
  return {"clouds.kind", "clouds.cover", "clouds.speed", "clouds.heading"};
}

/// Open hills, 400 m wide, with a boulder here and there and a path, from a slope above a hollow:
/// ground that faces the sun and ground that does not share the picture.
void lay_out_hills(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.size_m = 400.0;
  terrain.samples = 769;
  terrain.hill_height_m = 30.0;
  terrain.relief_m = 7.0;
  terrain.relief_feature_m = 150.0;
  terrain.streams = 0.15;
  terrain.boulders_per_hectare = 15.0;
  terrain.grazing_steps = 0.5;
  scene.paths = {
      {{156.0, 148.0, 165.0, 155.5, 174.0, 163.5, 184.0, 166.5, 189.0, 175.0, 200.0, 195.0}, 0.8}};
  scene.grass.lods = {126, 62, 30};
  scene.camera.eye_m = {150.0, 150.0};
  scene.camera.target_m = {320.0, 180.0};
}

KeyNames keys_of_hills() {
  return {"terrain.hill_height",    "terrain.size",    "terrain.samples",  "terrain.relief",
          "terrain.relief_feature", "terrain.streams", "terrain.boulders", "terrain.grazing_steps",
          "grass.levels",           "paths.way",       "paths.width"};
}

/// Bushes here and there, as on hills that are grazed.
Species few_bushes(const Scene& scene) {
  Species few = bushes(scene);
  few.habitat.cover = 0.08;
  return few;
}

/// Thin grass on less of the ground than on dry mountains.
Species little_pale_grass(const Scene& scene) {
  Species grass = pale_grass(scene);
  grass.habitat.cover = 0.3;
  return grass;
}

Starter hillside() {
  Scene scene;
  lay_out_hills(scene);
  scene.clouds = {fair_weather()};
  Starter starter = {
      "hillside", "Hills in flower, whose grass withers, under fair-weather clouds.", scene,
      joined(keys_of_hills(),
             joined(keys_of_clouds(), {"grass.blades", "ageing.water", "ageing.frames",
                                       "sun.elevation", "sun.azimuth", "wind.grass", "wind.speed",
                                       "wind.heading", "film.frame_seconds"}))};
  let_grow(starter,
           {little_pale_grass(scene), lush_grass(scene), few_bushes(scene), hawkbits(scene)});
  return starter;
}

/// Numbers from `first` to `last`, evenly spread, with four decimals.
std::vector<double> evenly(int count, double first, double last) {
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    numbers.push_back(std::round(1e4 * (first + (last - first) * i / (count - 1))) / 1e4);
  return numbers;
}

/// Rock above its meadow, 3 km wide, seen from the foot.
void raise_mountain(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.shape = TerrainShape::mountain;
  terrain.size_m = 3000.0;
  terrain.samples = 1025;
  terrain.hill_height_m = 750.0;
  terrain.relief_m = 20.0;
  terrain.relief_feature_m = 700.0;
  terrain.streams = 0.3;
  terrain.talus_deg = 60.0;
  terrain.rock_slope_deg = 42.0;
  terrain.boulders_per_hectare = 80.0;
  scene.growth.steepest_deg = 44.0;
  scene.growth.cover = 0.96;
  scene.growth.feature_m = 25.0;
  scene.grass.lods = {126, 62, 30};
  scene.sky.visual_range_m = 60e3;
  scene.camera = {.eye_m = {1500.0, 100.0},
                  .eye_height_m = 1.8,
                  .target_m = {1500.0, 1300.0},
                  .target_height_m = 40.0,
                  .field_of_view_deg = 50.0};
}

Starter mountain() {
  Scene scene;
  raise_mountain(scene);
  scene.film.frame_seconds = 60.0;
  scene.sun.azimuth_deg = 245.0;
  scene.sun.elevation_deg = 32.0;
  scene.clouds = {fair_weather()};
  Starter starter = {
      "mountain", "Rock and scree where it is steep, and a meadow before them that withers.", scene,
      joined(keys_of_clouds(),
             {"terrain.hill_height", "terrain.shape",     "terrain.size",
              "terrain.samples",     "terrain.relief",    "terrain.relief_feature",
              "terrain.streams",     "terrain.talus",     "terrain.rock_slope",
              "terrain.boulders",    "growth.cover",      "growth.steepest",
              "growth.feature",      "grass.levels",      "ageing.frames",
              "film.frame_seconds",  "sky.visual_range",  "sun.elevation",
              "sun.azimuth",         "camera.eye_height", "camera.target_height",
              "camera.field_of_view"})};
  let_grow(starter, {pale_grass(scene), lush_grass(scene), hawkbits(scene)});
  return starter;
}

CloudLayer fibres() {
  CloudLayer layer;
  layer.kind = CloudKind::cirrus;
  layer.speed_m_s = 25.0;
  layer.heading_deg = 80.0;
  return layer;
}

Starter clouds() {
  Scene scene;
  scene.grass.key_frames = {0.0, 0.05, 1.0};
  scene.ageing.frames = evenly(24, 0.0, 0.05);
  scene.film.frame_seconds = 4.0;
  scene.sky.visual_range_m = 60e3;
  scene.sun.azimuth_deg = 290.0;
  scene.sun.elevation_deg = 25.0;
  scene.camera.eye_m = {23.0, 2.0};
  scene.camera.target_m = {15.0, 20.0};
  scene.camera.target_height_m = 4.5;
  scene.camera.field_of_view_deg = 60.0;
  scene.clouds = {cumulus_layer(0.5), fibres()};
  scene.clouds[0].gathered = 0.4;
  scene.cloud_events = {
      {.kind = CloudEventKind::gather, .layer = 1, .start_s = 12.0, .duration_s = 60.0}};
  return {
      "clouds",
      "Clouds that drift and gather over a meadow that hardly withers meanwhile.",
      scene,
      {"terrain.hill_height", "grass.key_frames", "ageing.frames", "sun.elevation", "sun.azimuth",
       "sky.visual_range", "film.frame_seconds", "camera.target_height", "camera.field_of_view",
       "clouds.kind", "clouds.cover", "clouds.gathered", "clouds.speed", "clouds.heading",
       "cloud_events.kind", "cloud_events.layer", "cloud_events.start", "cloud_events.duration"}};
}

Starter snow() {
  constexpr double weathering = 0.3;
  Scene scene;
  scene.grass.key_frames = {0.0, weathering, 1.0};
  scene.ageing.age_spread = 0.0;
  scene.ageing.frames = std::vector<double>(16, weathering);
  scene.film.frame_seconds = 900.0;
  scene.weather.temperature_c = -1.5;
  scene.weather.precipitation_mm_h = 2.5;
  scene.wind.speed_m_s = 1.2;
  scene.sun.elevation_deg = 22.0;
  scene.camera = {.eye_m = {21.0, 1.5},
                  .eye_height_m = 1.15,
                  .target_m = {21.0, 11.0},
                  .target_height_m = 0.1,
                  .field_of_view_deg = 52.0};
  return {
      "snow",
      "Snow that falls for four hours, until ten centimetres lie.",
      scene,
      {"terrain.hill_height", "grass.key_frames", "ageing.frames", "ageing.age_spread",
       "sun.elevation", "sun.azimuth", "wind.speed", "wind.heading", "film.frame_seconds",
       "weather.temperature", "weather.precipitation", "snowfall.crystal", "snow_cover.drifting",
       "camera.eye_height", "camera.target_height", "camera.field_of_view"}};
}

/// Green, yellow, the first snow, a thaw, and the snow that stays, at last in the sun.
std::vector<SeasonKey> from_summer_to_winter() {
  return {{.date = {2026, 8, 25},
           .weathering = 0.0,
           .temperature_c = 15.0,
           .precipitation_mm_day = 0.0,
           .cloud_cover = 0.35},
          {.date = {2026, 9, 30}, .weathering = 0.45, .temperature_c = 8.0, .cloud_cover = 0.3},
          {.date = {2026, 10, 18},
           .weathering = 0.85,
           .temperature_c = 4.0,
           .precipitation_mm_day = 0.0,
           .cloud_cover = 0.7},
          {.date = {2026, 10, 24},
           .temperature_c = -1.0,
           .precipitation_mm_day = 6.0,
           .cloud_cover = 1.0},
          {.date = {2026, 11, 4},
           .weathering = 0.95,
           .temperature_c = 6.0,
           .precipitation_mm_day = 0.0,
           .cloud_cover = 0.3},
          {.date = {2026, 11, 22},
           .temperature_c = -3.0,
           .precipitation_mm_day = 16.0,
           .cloud_cover = 1.0},
          {.date = {2026, 11, 26},
           .temperature_c = -5.0,
           .precipitation_mm_day = 0.0,
           .cloud_cover = 0.3},
          {.date = {2026, 12, 8},
           .weathering = 1.0,
           .temperature_c = -6.0,
           .precipitation_mm_day = 0.0,
           .cloud_cover = 0.2}};
}

Starter season() {
  Scene scene;
  lay_out_hills(scene);
  scene.grass.key_frames = evenly(21, 0.0, 1.0);
  scene.season.first = {2026, 8, 25};
  scene.season.last = {2026, 12, 8};
  scene.season.frames = 36;
  scene.season_keys = from_summer_to_winter();
  scene.sun.time_h = 13.0;
  scene.sun.latitude_deg = 46.5;
  scene.sun.longitude_deg = 8.0;
  scene.film.frame_seconds = 4.0;
  scene.clouds = {cumulus_layer(0.45)};
  Starter starter = {
      "season", "From late summer to deep snow, three days from frame to frame.", scene,
      joined(keys_of_hills(),
             joined(keys_of_clouds(),
                    {"terrain.elevation", "terrain.centre", "grass.key_frames", "sun.time",
                     "sun.latitude", "sun.longitude", "film.frame_seconds", "season.first",
                     "season.last", "season.frames", "season.table", "season_keys.date",
                     "season_keys.weathering", "season_keys.temperature",
                     "season_keys.precipitation", "season_keys.cloud_cover", "camera.eye_height",
                     "camera.target_height", "camera.field_of_view"}))};
  // Each that does not stand everywhere doubles what every key frame takes.
  let_grow(starter, {few_bushes(scene), hawkbits(scene)});
  return starter;
}

}  // namespace

KeyNames joined(KeyNames names, const KeyNames& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

const std::vector<Starter>& starters() {
  static const std::vector<Starter> all = {hillside(), mountain(), clouds(), snow(), season()};
  return all;
}

}  // namespace wold::scene
