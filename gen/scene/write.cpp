#include "scene/write.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "core/error.h"
#include "scene/registry.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

std::string item_text(std::int64_t integer) { return std::to_string(integer); }
std::string item_text(double number) { return number_text(number); }
std::string item_text(const glm::dvec2& point) {
  return fmt::format("[{}, {}]", number_text(point.x), number_text(point.y));
}
std::string item_text(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none);
  return out.str();
}
std::string item_text(const std::optional<double>& number) {
  return number ? number_text(*number) : item_text(std::string(automatic_word));
}
std::string item_text(const CurveChoice& curve);

template <class T>
std::string list_text(const std::vector<T>& items) {
  std::string text;
  for (const T& item : items) text += (text.empty() ? "" : ", ") + item_text(item);
  return '[' + text + ']';
}

std::string item_text(const CurveChoice& curve) {
  return curve.points.empty() ? item_text(curve.name) : list_text(curve.points);
}

struct ValueWriter {
  std::string operator()(const auto& scalar) const { return item_text(scalar); }
  template <class T>
  std::string operator()(const std::vector<T>& items) const {
    return list_text(items);
  }
};

/// The key with its comment, after its table's header when it is the first of the table.
std::string key_text(const Key& key, const Scene& scene, std::string_view table_before) {
  std::string text;
  if (const std::string_view table = table_of(key.name); table != table_before)
    text += fmt::format("\n[{}]\n", table);
  return text + explained_assignment(key, scene);
}

/// The items one after the other. Only the first explains its keys.
std::string array_text(const TableArray& array, const Scene& scene) {
  std::string text;
  for (std::size_t item = 0; item < array.count(scene); ++item) {
    text += fmt::format("\n[[{}]]\n", array.name);
    for (const Key& key : array.keys(item))
      text += item == 0 ? explained_assignment(key, scene) : assignment(key, scene);
  }
  return text;
}

std::string markdown_row(const Key& key, const Scene& defaults) {
  return fmt::format("| `{}` | `{}` | {} | {} |\n", key.name, toml_text(key.get(defaults)),
                     expected(key), key.doc);
}

std::string markdown_heading(std::string_view heading, bool first) {
  return fmt::format("{}**{}**\n\n| key | default | accepts | meaning |\n|---|---|---|---|\n",
                     first ? "" : "\n", heading);
}

}  // namespace

std::string toml_text(const Value& value) { return std::visit(ValueWriter{}, value); }

std::string assignment(const Key& key, const Scene& scene) {
  return fmt::format("{} = {}\n", leaf_of(key.name), toml_text(key.get(scene)));
}

std::string explained_assignment(const Key& key, const Scene& scene) {
  return fmt::format("# {} Accepts {}.\n{}", key.doc, expected(key), assignment(key, scene));
}

std::string resolved_toml(const Scene& scene) {
  std::string text = "# A scene of Wold with every key.\n";
  std::string_view table;
  for (const Key& key : registry()) {
    text += key_text(key, scene, table);
    table = table_of(key.name);
  }
  for (const TableArray& array : table_arrays()) text += array_text(array, scene);
  return text;
}

std::string settings_text(const Scene& scene) {
  std::string text;
  const auto add = [&](const Key& key) {
    text += fmt::format("{} = {}\n", key.name, toml_text(key.get(scene)));
  };
  std::ranges::for_each(registry(), add);
  for (const TableArray& array : table_arrays())
    for (std::size_t item = 0; item < array.count(scene); ++item)
      std::ranges::for_each(item_keys(array, item), add);
  return text;
}

std::string keys_markdown() {
  const Scene defaults = defaults_with_items();
  std::string text, table = "none yet";
  for (const Key& key : registry()) {
    if (const std::string next(table_of(key.name)); next != table) {
      text += markdown_heading(next.empty() ? "top level" : "[" + next + "]", text.empty());
      table = next;
    }
    text += markdown_row(key, defaults);
  }
  for (const TableArray& array : table_arrays()) {
    text += markdown_heading(fmt::format("[[{}]], once for each {}, at most {}", array.name,
                                         array.item, array.max_items),
                             false);
    for (const Key& key : array.keys(0)) text += markdown_row(key, defaults);
  }
  return text;
}

}  // namespace wold::scene
