#include "scene/document.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

#include "scene/text.h"

namespace wold::scene {
namespace {

/// toml++ frees nested tables by recursion, so a text of a million "a.a.a" would overflow the
/// stack. Every second dot of such a chain at least is counted here, those of numbers are not.
constexpr std::size_t max_key_dots = 2000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Dots that are not a number's: without a digit on both sides, or right of another dot.
std::size_t key_dots(std::string_view text) {
  std::size_t dots = 0;
  bool dot_before_digits = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '.') {
      const bool digits =
          i > 0 && is_digit(text[i - 1]) && i + 1 < text.size() && is_digit(text[i + 1]);
      if (!digits || dot_before_digits) ++dots;
      dot_before_digits = true;
    } else if (!is_digit(text[i])) {
      dot_before_digits = false;
    }
  }
  return dots;
}

InputError at(const SourcePosition& where, std::string message) {
  return InputError({Problem{where, std::move(message)}});
}

void refuse_unreasonable(std::string_view text, const SourcePosition& where) {
  if (text.size() > largest_text_bytes)
    throw at(where, fmt::format("too much text, expected at most {} bytes", largest_text_bytes));
  if (key_dots(text) > max_key_dots)
    throw at(where, "tables nested far too deep; every key of a scene has at most one dot");
}

SourcePosition position(const toml::source_region& region, const std::string& file) {
  return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

toml::table parsed(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw at(position(error.source(), file),
             fmt::format("not valid TOML: {}", error.description()));
  }
}

/// TOML's nesting of values is limited by toml++, so this recursion is, too.
Node converted(const toml::node& node, const std::string& file) {
  Node result{position(node.source(), file),
              Unusable{"a date or time of TOML (here a day is [2026, 10, 20] and an hour 15.6)"},
              false};
  if (const auto* integer = node.as_integer()) result.value = integer->get();
  if (const auto* number = node.as_floating_point()) result.value = number->get();
  if (const auto* text = node.as_string()) result.value = text->get();
  if (const auto* truth = node.as_boolean())
    result.value = Unusable{truth->get() ? "true" : "false"};
  result.is_table = node.is_table();
  if (result.is_table) result.value = Unusable{"a table"};
  if (const auto* array = node.as_array()) {
    std::vector<Node> items;
    for (const toml::node& item : *array) items.push_back(converted(item, file));
    result.value = std::move(items);
  }
  return result;
}

/// A key as the registry would name it; one with a dot inside keeps its quotes to stay apart.
std::string spelled(const toml::key& key) {
  const bool dotted = key.str().find('.') != std::string_view::npos;
  return dotted ? fmt::format("\"{}\"", key.str()) : std::string(key.str());
}

std::vector<Entry> entries_of(const toml::table& table, const std::string& table_name,
                              const std::string& file) {
  const std::string prefix = table_name.empty() ? "" : table_name + ".";
  std::vector<Entry> entries;
  for (const auto& [key, node] : table)
    if (!prefix.empty() || !node.is_table())
      entries.push_back(
          {table_name, prefix + spelled(key), position(key.source(), file), converted(node, file)});
  return entries;
}

/// The tables of [[name]]; the array itself stays an entry, for those who expect something else.
void append_items(const std::string& name, const toml::array& tables, const std::string& file,
                  Document& document) {
  for (std::size_t item = 0; item < tables.size(); ++item) {
    const toml::table& table = *tables[item].as_table();
    document.sections.push_back({name, position(table.source(), file), item});
    const auto inner = entries_of(table, item_name(name, item), file);
    document.entries.insert(document.entries.end(), inner.begin(), inner.end());
  }
}

/// toml++ keeps keys by name; people read from the top.
template <class T>
void sort_by_position(std::vector<T>& items) {
  std::stable_sort(items.begin(), items.end(), [](const T& a, const T& b) {
    return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
  });
}

bool is_bare_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '-' || c == '.';
  });
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

void move_to(const SourcePosition& where, Node& node) {
  node.where = where;
  if (auto* items = std::get_if<std::vector<Node>>(&node.value))
    for (Node& item : *items) move_to(where, item);
}

/// The override's value; its nodes all lie at the override, which has no lines.
Node override_value(const std::string& text, const SourcePosition& where) {
  toml::table table;
  try {
    table = parsed("value = " + text, where.file);
  } catch (const InputError&) {
    if (is_bare_word(text)) return {where, text, false};
    throw at(where, fmt::format("{} is not a TOML value; write a list as 'key=[1, 2, 3]' and text "
                                "with spaces or signs as 'key=\"text\"'",
                                in_quotes(text)));
  }
  Node node = converted(*table.get("value"), where.file);
  move_to(where, node);
  return node;
}

}  // namespace

Document read_document(std::string_view text, const std::string& file_name) {
  refuse_unreasonable(text, {file_name});
  const toml::table root = parsed(text, file_name);
  Document document;
  document.entries = entries_of(root, "", file_name);
  for (const auto& [key, node] : root) {
    if (!node.is_table()) continue;
    document.sections.push_back({spelled(key), position(key.source(), file_name)});
    const auto inner = entries_of(*node.as_table(), spelled(key), file_name);
    document.entries.insert(document.entries.end(), inner.begin(), inner.end());
  }
  for (const auto& [key, node] : root)
    if (node.is_array_of_tables())
      append_items(spelled(key), *node.as_array(), file_name, document);
  sort_by_position(document.sections);
  sort_by_position(document.entries);
  return document;
}

Entry read_override(const std::string& text) {
  const SourcePosition where{"--set " + shown(text)};
  refuse_unreasonable(text, where);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || text.find_first_of("\r\n") != std::string::npos)
    throw at(where, "expected key=value, for example grass.blades=300");
  return {"", trimmed(text.substr(0, equals)), where,
          override_value(trimmed(text.substr(equals + 1)), where)};
}

}  // namespace wold::scene
