#include "scene/registry.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/write.h"

namespace wold::scene {
namespace {

/// A scene with one item, of defaults, in every array of tables.
Scene scene_with_items() {
  Scene scene;
  for (const TableArray& array : table_arrays()) array.append(scene);
  return scene;
}

/// The keys of that scene.
std::vector<Key> all_keys() {
  std::vector<Key> keys = registry();
  for (const TableArray& array : table_arrays())
    for (const Key& key : array.keys(0)) keys.push_back(key);
  return keys;
}

TEST(Registry, EveryKeyIsDescribedAndItsDefaultIsAccepted) {
  const Scene defaults = scene_with_items();
  std::set<std::string> names;
  for (const Key& key : all_keys()) {
    SCOPED_TRACE(key.name);
    EXPECT_TRUE(names.insert(key.name).second) << "twice";
    EXPECT_EQ(key.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_."),
              std::string::npos);
    ASSERT_FALSE(key.doc.empty());
    EXPECT_EQ(key.doc.back(), '.');
    EXPECT_FALSE(expected(key).empty());
    EXPECT_TRUE(key.unit.empty() || expected(key).find(" " + key.unit) != std::string::npos);
    EXPECT_FALSE(fault_of(key, key.get(defaults)));
  }
}

TEST(Registry, EveryWordOfAModeReadsBack) {
  Scene scene = scene_with_items();
  for (const Key& key : all_keys()) {
    if (key.kind != Kind::word) continue;
    SCOPED_TRACE(key.name);
    EXPECT_GE(key.words.size(), 2U);
    for (const std::string& word : key.words) {
      key.set(scene, word);
      EXPECT_EQ(key.get(scene), Value(word));
    }
  }
}

/// A value that the key accepts and that differs from the default.
Value another_value(const Key& key, const Value& value) {
  switch (key.kind) {
    case Kind::integer:
      if (!key.members.empty()) return key.members.back();
      return std::get<std::int64_t>(value) + 1;
    case Kind::number:
      return 0.5 * (std::get<double>(value) + key.highest);
    case Kind::automatic:
      return std::optional<double>(0.5 * (key.lowest + key.highest));
    case Kind::files:
      return std::vector<std::string>{"/other", "/and another"};
    case Kind::name:
      return "other";
    case Kind::file:
      return "/other";
    case Kind::system:
      return "EPSG:4326";
    case Kind::word:
    case Kind::words:
      return key.words[key.words[0] == std::get<std::string>(value) ? 1 : 0];
    case Kind::integers: {
      auto items = std::get<std::vector<std::int64_t>>(value);
      if (items.empty())
        items = {1, 2};
      else if (items.size() > 2)
        items.pop_back();
      else
        items[0] += 1;
      return items;
    }
    case Kind::numbers: {
      auto items = std::get<std::vector<double>>(value);
      if (key.list.spans_range || items.empty())
        items = {key.lowest, key.highest};
      else
        items[0] = 0.5 * (items[0] + key.highest);
      return items;
    }
    case Kind::curve:
      return CurveChoice{"", {{0.0, 1.0}, {1.0, 0.25}}};
    case Kind::curves:
      return std::vector<CurveChoice>{{key.words.back(), {}}, {"", {{0.0, 0.0}, {1.0, 0.25}}}};
  }
  return value;
}

TEST(Registry, EveryKeyReachesAFieldOfItsOwn) {
  const Scene defaults = scene_with_items();
  for (const Key& changed : all_keys()) {
    SCOPED_TRACE(changed.name);
    Scene scene = defaults;
    const Value other = another_value(changed, changed.get(scene));
    ASSERT_FALSE(fault_of(changed, other));
    changed.set(scene, other);
    for (const Key& key : all_keys())
      EXPECT_EQ(key.get(scene), key.name == changed.name ? other : key.get(defaults)) << key.name;
  }
}

TEST(Registry, TheManualListsEveryKeyOnce) {
  const std::string manual = keys_markdown();
  for (const Key& key : all_keys()) {
    const std::string cell = "| `" + key.name + "` |";
    const std::size_t first = manual.find(cell);
    ASSERT_NE(first, std::string::npos) << key.name;
    EXPECT_EQ(manual.find(cell, first + 1), std::string::npos) << key.name;
  }
}

TEST(Registry, KnowsWhatTheUserMayHaveMeant) {
  EXPECT_EQ(nearest_key("grass.blade"), "grass.blades");
  EXPECT_EQ(nearest_key("grass.height_m"), "grass.height");
  EXPECT_EQ(nearest_key("gras.patch"), "grass.patch");
  EXPECT_EQ(nearest_key("sun.elevaiton"), "sun.elevation");
  EXPECT_EQ(nearest_key("turbidity"), "sky.turbidity");
  EXPECT_EQ(nearest_key("zebra"), "");
  EXPECT_EQ(nearest_table("camrea"), "camera");
  EXPECT_EQ(nearest_table("meteor"), "");
}

}  // namespace
}  // namespace wold::scene
