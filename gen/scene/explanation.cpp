#include "scene/explanation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// All of them, in the order in which a scene is written.
std::vector<Section> sections() {
  std::vector<Section> all;
  for (const Key& key : registry()) {
    Section section = section_of(table_of(key.name));
    if (all.empty() || all.back().header != section.header) all.push_back(std::move(section));
  }
  for (const TableArray& array : table_arrays()) all.push_back(section_of(array));
  return all;
}

/// Keys and tables that may have been meant: one that is spelt nearly so, or else tables whose
/// names have the word in them, such as "snowfall" for "snow.falling".
std::string meant(std::string_view name) {
  std::string near = nearest_key(name);
  if (near.empty()) near = nearest_table(name);
  if (!near.empty()) return near;
  const std::string_view word = name.substr(0, name.find('.'));
  std::vector<std::string_view> tables;
  const std::vector<Section> all = sections();
  for (const Section& section : all)
    if (const std::string_view table = table_of(section.keys.front().name);
        word.size() > 2 && table.find(word) != std::string_view::npos)
      tables.push_back(table);
  return fmt::format("{}", fmt::join(tables, " or "));
}

[[noreturn]] void throw_unknown(std::string_view name) {
  const std::string near = meant(name);
  throw InputError(fmt::format(
      "found {}, expected a key or a table of a scene, such as sun.elevation or sun; {}",
      in_quotes(name),
      near.empty() ? "wold explain lists all" : fmt::format("did you mean {}?", near)));
}

/// A line for each table, with its keys.
std::string tables_text() {
  std::string text;
  for (const Section& section : sections()) {
    std::vector<std::string_view> leaves;
    for (const Key& key : section.keys) leaves.push_back(leaf_of(key.name));
    const std::string header = section.header.substr(0, section.header.find('\n'));
    text += fmt::format("{}: {}\n", header.empty() ? "before all tables" : header,
                        fmt::join(leaves, ", "));
  }
  return text;
}

Section known_section(std::string_view name) {
  Section section = section_with(present_name(name));
  if (name.empty() || section.keys.empty()) throw_unknown(name);
  return section;
}

}  // namespace

std::vector<Key> keys_named(std::string_view name) {
  if (!name.empty()) return known_section(name).keys;
  std::vector<Key> all;
  for (const Section& section : sections())
    all.insert(all.end(), section.keys.begin(), section.keys.end());
  return all;
}

std::string explanation(std::string_view name) {
  if (name.empty()) return tables_text();
  const Section section = known_section(name);
  const Scene defaults = defaults_with_items();
  std::string text = section.header;
  for (const Key& key : section.keys) text += explained_assignment(key, defaults);
  return text;
}

}  // namespace wold::scene
