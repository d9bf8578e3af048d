#include "scene/starter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "core/error.h"
#include "scene/registry.h"
#include "scene/starter_at_place.h"
#include "scene/starter_kinds.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

const KeyNames& keys_of_every_kind() {
  static const KeyNames names = {"name",           "seed",           "grass.height",
                                 "camera.eye",     "camera.target",  "render.size",
                                 "render.samples", "render.renderer"};
  return names;
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
  if (longitude_latitude_deg) move_to(scene, *longitude_latitude_deg);
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
      "# These are the keys one changes first; `wold explain` names all of them: shots, species,\n"
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
