#include "scene/registry.h"

#include <algorithm>

#include "scene/keys.h"
#include "scene/nearest.h"

namespace wold::scene {
namespace {

std::vector<Key> all_keys() {
  std::vector<Key> all;
  for (const auto& keys :
       {top_level_keys(), terrain_keys(), growth_keys(), grass_keys(), ageing_keys(), fur_keys(),
        sun_keys(), sky_keys(), wind_keys(), camera_keys(), render_keys()})
    all.insert(all.end(), keys.begin(), keys.end());
  return all;
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

const Key* find_key(std::string_view name) {
  const auto& keys = registry();
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
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

std::string nearest_table(std::string_view name) { return nearest(name, tables()); }

}  // namespace wold::scene
