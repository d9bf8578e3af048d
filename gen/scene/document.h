#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"

/// A TOML text as plain data with positions: what parsing knows before it knows the scene's keys.
namespace wold::scene {

/// Something no key accepts: a truth value, a date, a table. Only its description is kept.
struct Unusable {
  std::string description;
};

struct Node {
  SourcePosition where;
  std::variant<std::int64_t, double, std::string, std::vector<Node>, Unusable> value;
  bool is_table = false;
};

/// A key with its value.
struct Entry {
  std::string table;     ///< the table it stands in, "" at the top level and for overrides
  std::string name;      ///< dotted inside a table; "clouds[1].kind" in the first of [[clouds]]
  SourcePosition where;  ///< of the key
  Node node;
};

/// A table of the top level, or an item of an array of tables.
struct Section {
  std::string name;
  SourcePosition where;
  std::optional<std::size_t> item = std::nullopt;  ///< which one of an array, from 0
};

struct Document {
  std::vector<Section> sections;  ///< in the text's order
  std::vector<Entry> entries;     ///< in the text's order
};

/// The largest scene text, in bytes; a scene of 10000 frames needs a fifth of it.
inline constexpr std::size_t largest_text_bytes = std::size_t{1} << 20;

/// Parses a whole text. Throws InputError for a syntax error, a repeated key, text that is not
/// UTF-8, too much text or far too deep nesting.
Document read_document(std::string_view text, const std::string& file_name);

/// Parses one `key=value` of the command line; the value is TOML, or a bare word for text. Its
/// position is "--set key=value". Throws InputError.
Entry read_override(const std::string& text);

/// What a node is, for "found ...": `"both"`, `3.5`, `a list of 3`, `a table`.
std::string description(const Node& node);

}  // namespace wold::scene
