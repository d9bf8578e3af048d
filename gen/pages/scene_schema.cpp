#include "pages/scene_schema.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/version.h"
#include "pages/key_json.h"
#include "scene/old_names.h"
#include "scene/registry.h"

namespace wold::pages {
namespace {

using nlohmann::ordered_json;
using scene::Key;

ordered_json property_of(const Key& key, const scene::Scene& defaults) {
  ordered_json property = accepted_by(key);
  property["description"] = fmt::format("{} Accepts {}.", key.doc, scene::expected(key));
  property["default"] = json_of(key.get(defaults));
  return property;
}

ordered_json table_with(ordered_json properties) {
  return {
      {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

/// The table's properties, or those of an array's items.
ordered_json& properties_of(ordered_json& tables, const std::string& table) {
  ordered_json& found = tables[table];
  return found.contains("items") ? found["items"]["properties"] : found["properties"];
}

ordered_json array_of(const scene::TableArray& array, const scene::Scene& defaults) {
  ordered_json properties = ordered_json::object();
  for (const Key& key : array.keys(0))
    properties[std::string(scene::leaf_of(key.name))] = property_of(key, defaults);
  return {{"type", "array"},
          {"description", fmt::format("Once for each {}.", array.item)},
          {"maxItems", array.max_items},
          {"items", table_with(std::move(properties))}};
}

void add_old_names(ordered_json& tables) {
  for (const scene::OldName& renamed : scene::old_names()) {
    ordered_json& properties =
        properties_of(tables, std::string(scene::table_of(renamed.old_name)));
    ordered_json old = properties.at(std::string(scene::leaf_of(renamed.name)));
    old["deprecated"] = true;
    old["description"] = fmt::format("Is called {} now.", renamed.name);
    properties[std::string(scene::leaf_of(renamed.old_name))] = std::move(old);
  }
}

}  // namespace

std::string scene_schema() {
  const scene::Scene defaults = scene::defaults_with_items();
  ordered_json tables = ordered_json::object();
  for (const Key& key : scene::registry()) {
    const std::string table(scene::table_of(key.name)), leaf(scene::leaf_of(key.name));
    if (table.empty()) {
      tables[leaf] = property_of(key, defaults);
      continue;
    }
    if (!tables.contains(table)) tables[table] = table_with(ordered_json::object());
    properties_of(tables, table)[leaf] = property_of(key, defaults);
  }
  for (const scene::TableArray& array : scene::table_arrays())
    tables[array.name] = array_of(array, defaults);
  add_old_names(tables);
  ordered_json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                         {"title", fmt::format("A scene of Wold {}", version)}};
  schema.update(table_with(std::move(tables)));
  return schema.dump(1) + "\n";
}

}  // namespace wold::pages
