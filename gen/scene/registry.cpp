#include "scene/registry.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/keys.h"
#include "scene/nearest.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

std::vector<Key> all_keys() {
  std::vector<Key> all;
  for (const auto& keys :
       {top_level_keys(), terrain_keys(), growth_keys(), grass_keys(), ageing_keys(), fur_keys(),
        sun_keys(), sky_keys(), wind_keys(), film_keys(), weather_keys(), season_keys(),
        snowfall_keys(), rainfall_keys(), snow_cover_keys(), camera_keys(), render_keys()})
    all.insert(all.end(), keys.begin(), keys.end());
  return all;
}

/// A species is what [grass], [ageing] and [fur] say, as far as its own keys do not.
void take_common(Scene& scene, std::size_t item) {
  scene.species[item].plant = scene.grass;
  scene.species[item].physiology = scene.ageing;
}

void append_shot(Scene& scene) {
  scene.shots.push_back({.name = fmt::format("shot_{}", scene.shots.size() + 1)});
}

/// A shot is taken as [camera] and [film] say, as far as its own keys do not.
void take_camera_and_rate(Scene& scene, std::size_t item) {
  scene.shots[item].camera = scene.camera;
  scene.shots[item].frame_seconds = scene.film.frame_seconds;
}

std::vector<TableArray> all_arrays() {
  return {{"species", "kind of plant", max_species,
           [](const Scene& scene) { return scene.species.size(); },
           [](Scene& scene) { scene.species.emplace_back(); }, species_keys, take_common},
          {"clouds", "layer of clouds", max_cloud_layers,
           [](const Scene& scene) { return scene.clouds.size(); },
           [](Scene& scene) { scene.clouds.emplace_back(); }, cloud_keys},
          {"cloud_events", "event on the clouds' time line", max_cloud_events,
           [](const Scene& scene) { return scene.cloud_events.size(); },
           [](Scene& scene) { scene.cloud_events.emplace_back(); }, cloud_event_keys},
          {"season_keys", "day of the season", max_season_keys,
           [](const Scene& scene) { return scene.season_keys.size(); },
           [](Scene& scene) { scene.season_keys.emplace_back(); }, season_key_keys},
          {"shots", "shot of the film", max_shots,
           [](const Scene& scene) { return scene.shots.size(); }, append_shot, shot_keys,
           take_camera_and_rate},
          {"paths", "path through the meadow", max_paths,
           [](const Scene& scene) { return scene.paths.size(); },
           [](Scene& scene) { scene.paths.emplace_back(); }, path_keys},
          {"cover_classes", "class of land cover", max_cover_classes,
           [](const Scene& scene) { return scene.cover_classes.size(); },
           [](Scene& scene) { scene.cover_classes.emplace_back(); }, cover_class_keys}};
}

std::vector<std::string> all_tables() {
  std::vector<std::string> names;
  for (const Key& key : registry()) {
    const std::string table(table_of(key.name));
    if (!table.empty() && (names.empty() || names.back() != table)) names.push_back(table);
  }
  return names;
}

/// The key of another table that has the same last part, when there is just one.
std::string same_leaf(std::string_view leaf) {
  std::string found;
  for (const Key& key : registry()) {
    if (leaf_of(key.name) != leaf) continue;
    if (!found.empty()) return {};
    found = key.name;
  }
  return found;
}

}  // namespace

const std::vector<Key>& registry() {
  static const std::vector<Key> keys = all_keys();
  return keys;
}

Scene defaults_with_items() {
  Scene scene;
  for (const TableArray& array : table_arrays()) array.append(scene);
  return scene;
}

const Key* find_key(std::string_view name) {
  const auto& keys = registry();
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

const std::vector<TableArray>& table_arrays() {
  static const std::vector<TableArray> arrays = all_arrays();
  return arrays;
}

const TableArray* find_array(std::string_view name) {
  const auto& arrays = table_arrays();
  const auto found = std::ranges::find(arrays, name, &TableArray::name);
  return found == arrays.end() ? nullptr : &*found;
}

std::vector<Key> item_keys(const TableArray& array, std::size_t item) {
  std::vector<Key> keys = array.keys(item);
  for (Key& key : keys)
    key.name = fmt::format("{}.{}", item_name(array.name, item), leaf_of(key.name));
  return keys;
}

const std::vector<std::string>& tables() {
  static const std::vector<std::string> names = all_tables();
  return names;
}

std::string_view table_of(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot);
}

std::string_view leaf_of(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

std::string nearest_key(std::string_view name) {
  if (std::string found = same_leaf(leaf_of(name)); !found.empty()) return found;
  std::vector<std::string> same_table, elsewhere;
  for (const Key& key : registry())
    (table_of(key.name) == table_of(name) ? same_table : elsewhere).push_back(key.name);
  const std::string near = nearest(name, same_table);
  return near.empty() ? nearest(name, elsewhere) : near;
}

std::string nearest_table(std::string_view name) {
  std::vector<std::string> names = tables();
  for (const TableArray& array : table_arrays()) names.push_back(array.name);
  return nearest(name, names);
}

std::string nearest_of(std::string_view name, const std::vector<Key>& keys) {
  std::vector<std::string> leaves;
  leaves.reserve(keys.size());
  for (const Key& key : keys) leaves.emplace_back(leaf_of(key.name));
  const std::string near = nearest(leaf_of(name), leaves);
  return near.empty() ? near : fmt::format("{}.{}", table_of(name), near);
}

}  // namespace wold::scene
