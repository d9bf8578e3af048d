#include "pages/scene_schema.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/version.h"
#include "scene/old_names.h"
#include "scene/registry.h"

namespace wold::pages {
namespace {

using nlohmann::ordered_json;
using scene::CurveChoice;
using scene::Key;
using scene::Kind;
using scene::ListRule;

ordered_json text_of(const char* pattern) { return {{"type", "string"}, {"pattern", pattern}}; }

ordered_json word_of(const Key& key) { return {{"enum", key.words}}; }

ordered_json number_of(const Key& key) {
  return {{"type", "number"}, {"minimum", key.lowest}, {"maximum", key.highest}};
}

ordered_json integer_of(const Key& key) {
  if (!key.members.empty()) return {{"enum", key.members}};
  return {{"type", "integer"},
          {"minimum", static_cast<std::int64_t>(key.lowest)},
          {"maximum", static_cast<std::int64_t>(key.highest)}};
}

ordered_json list_of(const ListRule& rule, ordered_json items) {
  return {{"type", "array"},
          {"items", std::move(items)},
          {"minItems", rule.min_items},
          {"maxItems", rule.max_items}};
}

ordered_json either(ordered_json one, ordered_json other) {
  return {{"anyOf", {std::move(one), std::move(other)}}};
}

/// A curve is one of the words or points of weathering degree and value.
ordered_json curve_of(const Key& key) {
  const ordered_json degree = {{"type", "number"}, {"minimum", 0}, {"maximum", 1}};
  const ordered_json point = {{"type", "array"},
                              {"prefixItems", {degree, number_of(key)}},
                              {"minItems", 2},
                              {"maxItems", 2}};
  return either(word_of(key), list_of(key.points, point));
}

/// What the key accepts.
ordered_json accepted_by(const Key& key) {
  switch (key.kind) {
    case Kind::integer:
      return integer_of(key);
    case Kind::number:
      return number_of(key);
    case Kind::automatic:
      return either(number_of(key), {{"const", scene::automatic_word}});
    case Kind::name:
      return text_of("^[A-Za-z0-9][A-Za-z0-9_.-]{0,63}$");
    case Kind::word:
      return word_of(key);
    case Kind::words:
      return either(word_of(key), list_of(key.list, word_of(key)));
    case Kind::file:
      return {{"type", "string"}};
    case Kind::system:
      return text_of("^(EPSG:[0-9]{1,6})?$");
    case Kind::files:
      return list_of(key.list, {{"type", "string"}});
    case Kind::integers:
      return list_of(key.list, integer_of(key));
    case Kind::numbers:
      return list_of(key.list, number_of(key));
    case Kind::curve:
      return curve_of(key);
    case Kind::curves:
      return list_of(key.list, curve_of(key));
  }
  return {};
}

struct JsonValue {
  ordered_json operator()(const auto& value) const { return value; }
  ordered_json operator()(const std::optional<double>& number) const {
    return number ? ordered_json(*number) : ordered_json(scene::automatic_word);
  }
  ordered_json operator()(const CurveChoice& curve) const {
    if (curve.points.empty()) return curve.name;
    ordered_json points = ordered_json::array();
    for (const glm::dvec2& point : curve.points) points.push_back({point.x, point.y});
    return points;
  }
  ordered_json operator()(const std::vector<CurveChoice>& curves) const {
    ordered_json items = ordered_json::array();
    for (const CurveChoice& curve : curves) items.push_back((*this)(curve));
    return items;
  }
};

ordered_json property_of(const Key& key, const scene::Scene& defaults) {
  ordered_json property = accepted_by(key);
  property["description"] = fmt::format("{} Accepts {}.", key.doc, scene::expected(key));
  property["default"] = std::visit(JsonValue(), key.get(defaults));
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
