#include "pages/key_json.h"

#include <nlohmann/json.hpp>

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

}  // namespace

ordered_json json_of(const scene::Value& value) { return std::visit(JsonValue(), value); }

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

}  // namespace wold::pages
