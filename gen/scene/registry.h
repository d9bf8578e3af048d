#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/scene.h"

/// The registry: every key of the scene file, stated once. Reading, checking, writing back, help
/// and the manual all walk this table.
namespace wold::scene {

/// What a key holds.
enum class Kind {
  integer,    ///< std::int64_t
  number,     ///< double; whole numbers are accepted
  name,       ///< std::string, safe as a file name
  automatic,  ///< std::optional<double>; without a number the word "auto"
  word,       ///< std::string, one of `words`
  words,      ///< std::string, one of `words`, or std::vector<std::string>, some of them
  file,       ///< std::string, an absolute path, or empty
  system,     ///< std::string, a coordinate system as "EPSG:4326", or empty
  files,      ///< std::vector<std::string>, absolute paths
  integers,   ///< std::vector<std::int64_t>
  numbers,    ///< std::vector<double>
  curve,      ///< CurveChoice: one of `words`, or points
  curves,     ///< std::vector<CurveChoice>
};

/// What stands for no number of Kind::automatic.
inline constexpr const char* automatic_word = "auto";

using Value = std::variant<std::int64_t, double, std::optional<double>, std::string,
                           std::vector<std::int64_t>, std::vector<double>, std::vector<std::string>,
                           CurveChoice, std::vector<CurveChoice>>;

/// How the items of a list follow each other; increasing and decreasing are strict.
enum class Order { any, increasing, decreasing, not_falling };

/// What a list must be, beyond the range of its items.
struct ListRule {
  std::size_t min_items = 1;
  std::size_t max_items = 1;
  Order order = Order::any;
  bool spans_range = false;  ///< the first item is the lowest value, the last the highest
};

/// One key of the scene file.
struct Key {
  std::string name;  ///< dotted: "grass.patch"; without a dot at the top level
  std::string unit;  ///< "m", "deg", ...; "" for plain numbers and words
  std::string doc;   ///< one sentence
  Kind kind = Kind::number;
  double lowest = 0.0;  ///< range of a number or of every item, ends included
  double highest = 0.0;
  std::vector<std::string> words;     ///< allowed words, for Kind::word, words and curves
  std::vector<std::int64_t> members;  ///< if any: the only allowed integers
  ListRule list;                      ///< of a list
  ListRule points;                    ///< of a curve's points; its order is that of their values
  std::function<Value(const Scene&)> get;
  /// Stores a value of the key's kind that has passed fault_of().
  std::function<void(Scene&, const Value&)> set;
};

/// A table that may stand any number of times, as [[clouds]]: each is an item of a list of the
/// scene and has the same keys.
struct TableArray {
  std::string name;           ///< "clouds"
  std::string item;           ///< what one of them is: "layer of clouds"
  std::size_t max_items = 1;  ///< items
  std::function<std::size_t(const Scene&)> count;
  std::function<void(Scene&)> append;  ///< one more item, of defaults
  /// The keys of the item with that index, from 0: "clouds.kind", ...
  std::function<std::vector<Key>(std::size_t item)> keys;
  /// Gives the item with that index what single tables say for all items; none: nothing does. To be
  /// called when these have been read and before the item's own keys are.
  std::function<void(Scene&, std::size_t item)> take_common = {};
};

/// All keys of tables that stand once, table by table, in the order they are written.
const std::vector<Key>& registry();

/// All tables that may stand many times, in the order they are written, after the others.
const std::vector<TableArray>& table_arrays();

/// A scene of defaults, with one item in each of the table_arrays(): every key has a value in it.
Scene defaults_with_items();

/// The key of that dotted name, or nullptr.
const Key* find_key(std::string_view name);

/// The array of that name, or nullptr.
const TableArray* find_array(std::string_view name);

/// The keys of an item, from 0, under the names they have in messages: "clouds[1].kind", ...
std::vector<Key> item_keys(const TableArray& array, std::size_t item);

/// The names of the tables that stand once, in their order, without the top level: "terrain", ...
const std::vector<std::string>& tables();

/// "grass" of "grass.patch", "" of "seed".
std::string_view table_of(std::string_view name);
/// "patch" of "grass.patch", "seed" of "seed".
std::string_view leaf_of(std::string_view name);

/// The known key or table the user may have meant, "" when nothing is near.
std::string nearest_key(std::string_view name);
std::string nearest_table(std::string_view name);
/// The one of these keys, all of one table, that the user may have meant.
std::string nearest_of(std::string_view name, const std::vector<Key>& keys);

/// What is wrong with a value: what was found, and where: in which item of a list (from 0), and in
/// which point of that when it is a curve. Empty: in the value as a whole.
struct Fault {
  std::string found;
  std::vector<std::size_t> path = {};
};

/// Checks a value of the key's kind against the key's range, words, members and list rule.
std::optional<Fault> fault_of(const Key& key, const Value& value);

/// What the key accepts, in words with unit and range: "a number from 0.05 to 20 m".
std::string expected(const Key& key);

/// The value as TOML; doubles as the shortest text that reads back the same.
std::string toml_text(const Value& value);

}  // namespace wold::scene
