#include "scene/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.h"
#include "scene/old_names.h"
#include "scene/registry.h"
#include "scene/text.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

/// Keys that stand under one header: "[sun]", "[[clouds]]", or "" at the top level.
struct Section {
  std::string header;
  std::vector<Key> keys;
};

Section section_of(const TableArray& array) {
  return {fmt::format("[[{}]]\n", array.name), array.keys(0)};
}

Section section_of(std::string_view table) {
  Section section{table.empty() ? "" : fmt::format("[{}]\n", table), {}};
  std::ranges::copy_if(registry(), std::back_inserter(section.keys),
                       [&](const Key& key) { return table_of(key.name) == table; });
  return section;
}

/// Where a key of that name would stand, and the table of that name; without keys when there is
/// none.
Section section_with(std::string_view name) {
  const bool is_table = name.find('.') == std::string_view::npos && find_key(name) == nullptr;
  const std::string_view table = is_table ? name : table_of(name);
  const TableArray* array = find_array(table);
  Section section = array != nullptr ? section_of(*array) : section_of(table);
  if (!is_table) std::erase_if(section.keys, [&](const Key& key) { return key.name != name; });
  return section;
}

[[noreturn]] void throw_unknown(std::string_view name) {
  std::string near = nearest_key(name);
  if (near.empty()) near = nearest_table(name);
  throw InputError(fmt::format(
      "found {}, expected a key or a table of a scene, such as sun.elevation or sun; {}",
      in_quotes(name),
      near.empty() ? "docs/keys.md has all" : fmt::format("did you mean {}?", near)));
}

Section known_section(std::string_view name) {
  Section section = section_with(present_name(name));
  if (name.empty() || section.keys.empty()) throw_unknown(name);
  return section;
}

}  // namespace

std::vector<Key> keys_named(std::string_view name) { return known_section(name).keys; }

std::string explanation(std::string_view name) {
  const Section section = known_section(name);
  const Scene defaults = defaults_with_items();
  std::string text = section.header;
  for (const Key& key : section.keys) text += explained_assignment(key, defaults);
  return text;
}

}  // namespace wold::scene
