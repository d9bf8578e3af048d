#include "pages/explanation_json.h"

#include <nlohmann/json.hpp>

#include "pages/key_json.h"
#include "scene/explanation.h"

namespace wold::pages {
namespace {

using nlohmann::ordered_json;

ordered_json explained(const scene::Key& key, const scene::Scene& defaults) {
  return {{"key", key.name},
          {"unit", key.unit},
          {"meaning", key.doc},
          {"accepts", scene::expected(key)},
          {"schema", accepted_by(key)},
          {"default", json_of(key.get(defaults))},
          {"repeats", scene::find_array(scene::table_of(key.name)) != nullptr}};
}

}  // namespace

std::string explanation_json(std::string_view name) {
  const scene::Scene defaults = scene::defaults_with_items();
  ordered_json keys = ordered_json::array();
  for (const scene::Key& key : scene::keys_named(name)) keys.push_back(explained(key, defaults));
  const ordered_json json = {{"version", 1}, {"keys", std::move(keys)}};
  return json.dump(2) + "\n";
}

}  // namespace wold::pages
