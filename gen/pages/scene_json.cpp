#include "pages/scene_json.h"

#include <nlohmann/json.hpp>

#include "pages/key_json.h"

namespace wold::pages {
namespace {

using nlohmann::ordered_json;

ordered_json values_of(const std::vector<scene::Key>& keys, const scene::Scene& scene) {
  ordered_json values = ordered_json::object();
  for (const scene::Key& key : keys)
    values[std::string(scene::leaf_of(key.name))] = json_of(key.get(scene));
  return values;
}

ordered_json items_of(const scene::TableArray& array, const scene::Scene& scene) {
  ordered_json items = ordered_json::array();
  for (std::size_t item = 0; item < array.count(scene); ++item)
    items.push_back(values_of(array.keys(item), scene));
  return items;
}

}  // namespace

std::string scene_json(const scene::Scene& scene) {
  ordered_json values = ordered_json::object();
  for (const scene::Key& key : scene::registry()) {
    const std::string table(scene::table_of(key.name)), leaf(scene::leaf_of(key.name));
    (table.empty() ? values[leaf] : values[table][leaf]) = json_of(key.get(scene));
  }
  for (const scene::TableArray& array : scene::table_arrays())
    values[array.name] = items_of(array, scene);
  const ordered_json json = {{"version", 1}, {"scene", std::move(values)}};
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace wold::pages
