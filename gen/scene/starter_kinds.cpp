#include "scene/starter_kinds.h"

#include <cmath>

namespace wold::scene {
namespace {

Starter hillside() {
  return {"hillside",
          "A withering meadow.",
          {},
          {"terrain.hill_height", "grass.blades", "ageing.water", "ageing.frames", "sun.elevation",
           "sun.azimuth", "wind.grass", "wind.speed", "wind.heading", "film.frame_seconds"}};
}

/// Numbers from `first` to `last`, evenly spread, with four decimals.
std::vector<double> evenly(int count, double first, double last) {
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    numbers.push_back(std::round(1e4 * (first + (last - first) * i / (count - 1))) / 1e4);
  return numbers;
}

void raise_mountain(Scene& scene) {
  Terrain& terrain = scene.terrain;
  terrain.shape = TerrainShape::mountain;
  terrain.size_m = 48.0;
  terrain.samples = 385;
  terrain.hill_height_m = 10.0;
  terrain.relief_m = 0.25;
  terrain.relief_feature_m = 5.0;
  terrain.streams = 0.3;
  terrain.talus_deg = 60.0;
  terrain.rock_slope_deg = 44.0;
  scene.growth.steepest_deg = 48.0;
  scene.growth.cover = 0.97;
  scene.grass.lods = {126, 62, 30};
  scene.camera.eye_m = {24.0, 0.5};
  scene.camera.target_m = {24.5, 16.0};
  scene.camera.target_height_m = 1.5;
  scene.camera.field_of_view_deg = 62.0;
}

const KeyNames& keys_of_mountains() {
  static const KeyNames names = {
      "terrain.hill_height", "terrain.shape",          "terrain.size",        "terrain.samples",
      "terrain.relief",      "terrain.relief_feature", "terrain.streams",     "terrain.talus",
      "terrain.rock_slope",  "growth.cover",           "growth.steepest",     "grass.levels",
      "camera.eye_height",   "camera.target_height",   "camera.field_of_view"};
  return names;
}

Starter mountain() {
  Scene scene;
  raise_mountain(scene);
  scene.camera.eye_height_m = 4.5;
  scene.sun.azimuth_deg = 255.0;
  scene.sun.elevation_deg = 28.0;
  return {"mountain", "Ridges and valleys, grass where it can stand, rock where it cannot.", scene,
          joined(keys_of_mountains(), {"ageing.frames", "sun.elevation", "sun.azimuth"})};
}

CloudLayer cumulus_layer(double cover) {
  CloudLayer layer;
  layer.kind = CloudKind::cumulus;
  layer.cover = cover;
  layer.heading_deg = 60.0;
  return layer;
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
  raise_mountain(scene);
  scene.camera.eye_height_m = 1.7;
  scene.camera.target_height_m = 1.2;
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
  return {"season", "From late summer to deep snow, three days from frame to frame.", scene,
          joined(keys_of_mountains(), {"terrain.elevation",
                                       "terrain.centre",
                                       "grass.key_frames",
                                       "sun.time",
                                       "sun.latitude",
                                       "sun.longitude",
                                       "film.frame_seconds",
                                       "season.first",
                                       "season.last",
                                       "season.frames",
                                       "season.table",
                                       "clouds.kind",
                                       "clouds.cover",
                                       "clouds.speed",
                                       "clouds.heading",
                                       "season_keys.date",
                                       "season_keys.weathering",
                                       "season_keys.temperature",
                                       "season_keys.precipitation",
                                       "season_keys.cloud_cover"})};
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
