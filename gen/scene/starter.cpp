#include "scene/starter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <string_view>

#include "core/error.h"
#include "scene/registry.h"
#include "scene/species.h"
#include "scene/sun_position.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

using Names = std::vector<std::string_view>;

/// A kind of starter scene: what it shows, its values, and the keys that it has besides those of
/// every kind.
struct Starter {
  std::string kind;
  std::string title;
  Scene scene;
  Names keys;
};

const Names& keys_of_every_kind() {
  static const Names names = {"name",          "seed",        "grass.height",   "camera.eye",
                              "camera.target", "render.size", "render.samples", "render.renderer"};
  return names;
}

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

const Names& keys_of_mountains() {
  static const Names names = {
      "terrain.hill_height", "terrain.shape",          "terrain.size",        "terrain.samples",
      "terrain.relief",      "terrain.relief_feature", "terrain.streams",     "terrain.talus",
      "terrain.rock_slope",  "growth.cover",           "growth.steepest",     "grass.levels",
      "camera.eye_height",   "camera.target_height",   "camera.field_of_view"};
  return names;
}

Names operator+(Names names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

Starter mountain() {
  Scene scene;
  raise_mountain(scene);
  scene.camera.eye_height_m = 4.5;
  scene.sun.azimuth_deg = 255.0;
  scene.sun.elevation_deg = 28.0;
  return {"mountain", "Ridges and valleys, grass where it can stand, rock where it cannot.", scene,
          keys_of_mountains() + Names{"ageing.frames", "sun.elevation", "sun.azimuth"}};
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
          keys_of_mountains() + Names{"terrain.elevation",
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
                                      "season_keys.cloud_cover"}};
}

const std::vector<Starter>& starters() {
  static const std::vector<Starter> all = {hillside(), mountain(), clouds(), snow(), season()};
  return all;
}

const Starter& starter_of(const std::string& kind) {
  const auto found = std::ranges::find(starters(), kind, &Starter::kind);
  if (found == starters().end())
    throw InputError(fmt::format("found the kind {}, expected one of: {}", kind,
                                 fmt::join(starter_kinds(), ", ")));
  return *found;
}

void check_name(const Scene& scene) {
  const Key& key = *find_key("name");
  if (const auto fault = fault_of(key, key.get(scene)))
    throw InputError(fmt::format("name: found {}, expected {}", fault->found, expected(key)));
}

/// What shapes a hill of the scene's own.
const Names& keys_of_own_ground() {
  static const Names names = {"terrain.hill_height",    "terrain.shape",   "terrain.relief",
                              "terrain.relief_feature", "terrain.streams", "terrain.talus"};
  return names;
}

/// Half a year later.
void move_date(std::vector<std::int64_t>& date) {
  constexpr std::chrono::days half_a_year(182);
  if (date.empty()) return;
  const std::chrono::year_month_day later(std::chrono::sys_days(date_of(date)) + half_a_year);
  date = {static_cast<int>(later.year()), static_cast<unsigned>(later.month()),
          static_cast<unsigned>(later.day())};
}

/// To a place where it is as late in the day and in the year.
void move(Scene& scene, const std::array<double, 2>& longitude_latitude_deg) {
  constexpr double deg_per_h = 15.0, day_h = 24.0;
  const auto& [longitude_deg, latitude_deg] = longitude_latitude_deg;
  const double later_h = (scene.sun.longitude_deg - longitude_deg) / deg_per_h;
  const double time_h = std::round(10.0 * (scene.sun.time_h + later_h)) / 10.0;
  scene.sun.time_h = time_h - day_h * std::floor(time_h / day_h);
  scene.sun.longitude_deg = longitude_deg;
  scene.sun.latitude_deg = latitude_deg;
  if (latitude_deg >= 0.0) return;
  move_date(scene.season.first);
  move_date(scene.season.last);
  for (SeasonKey& key : scene.season_keys) move_date(key.date);
}

/// Low evergreen bushes amid the grass, as on hills that are grazed: without anything as large the
/// eye does not see how far away a slope is.
Species bushes(const Scene& scene) {
  Species bushes = species_of(scene).front();
  bushes.name = "bushes";
  bushes.share = 2.0;
  bushes.habitat.cover = 0.12;
  bushes.habitat.feature_m = 2.0;
  bushes.habitat.steepest_deg = 45.0;
  Plant& plant = bushes.plant;
  plant.crown_m = 0.45;
  plant.height_m = 0.08;
  plant.height_spread = 0.35;
  plant.width_m = 0.016;
  plant.lean_deg = 28.0;
  plant.lean_spread_deg = 15.0;
  plant.bend = 0.4;
  plant.mingle = {{"evergreen", {}}};
  Physiology& physiology = bushes.physiology;
  physiology.droop = 0.4;
  physiology.litter = 0.1;
  physiology.fresh_spread = 0.08;
  physiology.chlorophyll_ug_cm2 = 58.0;
  physiology.carotenoid_ug_cm2 = 11.0;
  return bushes;
}

const Names& keys_of_bushes() {
  static const Names names = {"species.name",
                              "species.share",
                              "species.cover",
                              "species.feature",
                              "species.steepest",
                              "species.crown",
                              "species.height",
                              "species.height_spread",
                              "species.width",
                              "species.lean",
                              "species.lean_spread",
                              "species.bend",
                              "species.mingle",
                              "species.droop",
                              "species.litter",
                              "species.fresh_spread",
                              "species.chlorophyll_content",
                              "species.carotenoid_content"};
  return names;
}

/// The starter at a real place.
Starter at_place(Starter starter, const StarterPlace& place) {
  Scene& scene = starter.scene;
  if (place.longitude_latitude_deg) move(scene, *place.longitude_latitude_deg);
  scene.terrain = {};
  scene.terrain.elevation = place.elevation;
  scene.terrain.system = place.system;
  scene.terrain.size_m = place.size_m;
  scene.terrain.samples = place.samples;
  scene.sky.visual_range_m = place.visual_range_m;
  scene.camera.eye_m = place.eye_m;
  scene.camera.eye_height_m = place.eye_height_m;
  scene.camera.target_m = place.target_m;
  scene.camera.target_height_m = place.target_height_m;
  std::erase_if(starter.keys, [](std::string_view key) {
    return std::ranges::count(keys_of_own_ground(), key) > 0;
  });
  starter.keys =
      starter.keys + Names{"terrain.elevation",    "terrain.centre",    "terrain.size",
                           "terrain.samples",      "camera.eye_height", "camera.target_height",
                           "camera.field_of_view", "sky.visual_range"};
  if (!place.system.empty()) starter.keys.emplace_back("terrain.system");
  scene.species = {species_of(scene).front(), bushes(scene)};
  starter.keys = starter.keys + keys_of_bushes();
  return starter;
}

bool has(const Starter& starter, std::string_view key) {
  return std::ranges::count(keys_of_every_kind(), key) + std::ranges::count(starter.keys, key) > 0;
}

bool says_nothing(const Key& key, const Scene& scene) {
  return key.kind == Kind::automatic &&
         !std::get<std::optional<double>>(key.get(scene)).has_value();
}

/// Whether the item says with that key what single tables say for all items. Items have names.
bool says_common(const TableArray& array, const Scene& scene, std::size_t item, std::size_t key) {
  if (!array.take_common || array.keys(item)[key].kind == Kind::name) return false;
  Scene with_one_more = scene;
  array.append(with_one_more);
  const std::size_t added = array.count(scene);
  array.take_common(with_one_more, added);
  return array.keys(added)[key].get(with_one_more) == array.keys(item)[key].get(scene);
}

/// The items of a table that may stand many times; the first that has a key explains it.
std::string items_text(const TableArray& array, const Starter& starter, const Scene& scene) {
  std::string text;
  std::set<std::string> explained;
  for (std::size_t item = 0; item < array.count(scene); ++item) {
    text += fmt::format("\n[[{}]]\n", array.name);
    const std::vector<Key> keys = array.keys(item);
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const Key& key = keys[k];
      if (!has(starter, key.name) || (item > 0 && says_nothing(key, scene)) ||
          says_common(array, scene, item, k))
        continue;
      const bool is_first = explained.insert(key.name).second;
      text += is_first ? explained_assignment(key, scene) : assignment(key, scene);
    }
  }
  return text;
}

}  // namespace

const std::vector<std::string>& starter_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const Starter& starter : starters()) names.push_back(starter.kind);
    return names;
  }();
  return kinds;
}

Scene scene_of_kind(const std::string& kind,
                    const std::optional<std::array<double, 2>>& longitude_latitude_deg) {
  Scene scene = starter_of(kind).scene;
  if (longitude_latitude_deg) move(scene, *longitude_latitude_deg);
  return scene;
}

std::string starter_scene(const std::string& name, const std::string& kind,
                          const std::optional<StarterPlace>& place) {
  const Starter starter = place ? at_place(starter_of(kind), *place) : starter_of(kind);
  Scene scene = starter.scene;
  scene.name = name;
  check_name(scene);
  std::string text = fmt::format(
      "#:schema ./scene.schema.json\n"
      "# {1}\n# Look at it: wold preview {0}.toml; make it: wold render {0}.toml\n"
      "# These are the keys one changes first; `wold explain` names all of them: clouds, season,\n"
      "# snow_cover, weather and more. `wold explain KEY` says what one means. Editors complete "
      "and\n"
      "# check keys by the first line when there is a schema: wold schema >scene.schema.json\n\n",
      name, starter.title);
  std::string_view table;
  for (const Key& key : registry()) {
    if (!has(starter, key.name)) continue;
    if (const std::string_view next = table_of(key.name); next != table)
      text += fmt::format("\n[{}]\n", table = next);
    text += explained_assignment(key, scene);
  }
  for (const TableArray& array : table_arrays()) text += items_text(array, starter, scene);
  return text;
}

}  // namespace wold::scene
