#include "scene/parse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "core/files.h"
#include "scene/consistency.h"
#include "scene/convert.h"
#include "scene/document.h"
#include "scene/nearest.h"
#include "scene/old_names.h"
#include "scene/registry.h"
#include "scene/shots.h"
#include "scene/text.h"

namespace wold::scene {
namespace fs = std::filesystem;
namespace {

/// "clouds" of "clouds[1]".
std::string_view array_of(std::string_view item) { return item.substr(0, item.find('[')); }

bool is_table(std::string_view name) {
  return std::find(tables().begin(), tables().end(), name) != tables().end();
}

/// What the passes work on.
struct Reading {
  Scene scene;
  std::map<std::string, Key, std::less<>> item_keys;  ///< of all items of arrays
  Places places;
  std::vector<Problem> problems;
  std::vector<Problem> warnings;
};

std::string wrong_table_message(const std::string& name) {
  if (const Key* key = find_key(name))
    return fmt::format("{}: found a table, expected {}", key->name, expected(*key));
  if (const TableArray* array = find_array(name))
    return fmt::format("{0}: found the table [{0}], expected [[{0}]], once for each {1}", name,
                       array->item);
  return fmt::format("unknown table [{}]{}", shown(name), suggestion(nearest_table(name)));
}

void report_unknown_tables(const Document& document, Reading& reading) {
  for (const Section& section : document.sections)
    if (!section.item && !is_table(section.name))
      reading.problems.push_back({section.where, wrong_table_message(section.name)});
}

/// Makes the items of all arrays, of defaults, and their keys.
void append_items(const Document& document, Reading& reading) {
  for (const Section& section : document.sections) {
    const TableArray* array = section.item ? find_array(section.name) : nullptr;
    if (array == nullptr) continue;
    if (*section.item == array->max_items)
      reading.problems.push_back(
          {section.where, fmt::format("{}: found {} [[{}]], expected at most {}", array->name,
                                      array->max_items + 1, array->name, array->max_items)});
    if (*section.item >= array->max_items) continue;
    array->append(reading.scene);
    reading.places.given[item_name(array->name, *section.item)] = section.where;
    for (const Key& key : item_keys(*array, *section.item)) reading.item_keys[key.name] = key;
  }
}

/// The keys of the item of an array that a table's name means: "clouds[1]"; none if it is none.
std::vector<Key> keys_beside(const Reading& reading, std::string_view table) {
  std::vector<Key> keys;
  for (const auto& [name, key] : reading.item_keys)
    if (table_of(name) == table) keys.push_back(key);
  return keys;
}

const Key* known_key(const Reading& reading, std::string_view name) {
  const auto found = reading.item_keys.find(name);
  return found != reading.item_keys.end() ? &found->second : find_key(name);
}

std::string no_such_item(std::string_view name, const TableArray& array, std::size_t count) {
  const std::string there_is_no = fmt::format("{}: there is no such {}; ", shown(name), array.item);
  if (count == 0)
    return there_is_no +
           fmt::format("the scene has none, a table [[{}]] in it adds one", array.name);
  return there_is_no +
         fmt::format("the scene has {} of them, counted from {}", count, item_name(array.name, 0));
}

std::string unknown_key_message(const Entry& entry, const Reading& reading) {
  if (const TableArray* array = find_array(entry.name))
    return fmt::format("{0}: found {1}, expected tables [[{0}]], one for each {2}", entry.name,
                       description(entry.node), array->item);
  if (const auto keys = keys_beside(reading, table_of(entry.name)); !keys.empty())
    return fmt::format("unknown key {}{}", in_quotes(entry.name),
                       suggestion(nearest_of(entry.name, keys)));
  if (const TableArray* array = find_array(array_of(table_of(entry.name))))
    return no_such_item(entry.name, *array, array->count(reading.scene));
  if (is_table(entry.name))
    return fmt::format("{}: found {}, expected the table [{}]", entry.name, description(entry.node),
                       entry.name);
  return fmt::format("unknown key {}{}", in_quotes(entry.name),
                     suggestion(nearest_key(entry.name)));
}

/// Whether it is an array of tables, whose items are read as tables, or an empty one.
bool holds_items(const Entry& entry) {
  const auto* items = std::get_if<std::vector<Node>>(&entry.node.value);
  return find_array(entry.name) != nullptr && items != nullptr &&
         std::ranges::all_of(*items, [](const Node& item) { return item.is_table; });
}

/// Names the item of a list by its place, people count from 1.
std::string item_text(const Fault& fault) {
  if (fault.path.empty()) return fault.found;
  std::string place = fmt::format("item {}", fault.path[0] + 1);
  if (fault.path.size() > 1) place += fmt::format(", point {}", fault.path[1] + 1);
  return fmt::format("{} ({})", fault.found, place);
}

SourcePosition place_of(const Fault& fault, const Node& node) {
  const Node* at = &node;
  for (const std::size_t item : fault.path)
    if (const auto* items = std::get_if<std::vector<Node>>(&at->value)) at = &(*items)[item];
  return at->where;
}

/// The value of a key that holds paths, made absolute: relative ones start at `folder`.
Value rooted(const Key& key, const Value& value, const fs::path& folder) {
  const auto absolute = [&](const std::string& path) {
    return fs::absolute(folder / path).lexically_normal().string();
  };
  const auto* text = std::get_if<std::string>(&value);
  if (key.kind == Kind::file && text != nullptr && !text->empty()) return absolute(*text);
  if (key.kind != Kind::files) return value;
  auto paths = std::get<std::vector<std::string>>(value);
  std::ranges::transform(paths, paths.begin(), absolute);
  return paths;
}

std::optional<Problem> store(const Key& key, const Node& node, const fs::path& folder,
                             Scene& scene) {
  const auto problem = [&](const SourcePosition& where, const std::string& found) {
    return Problem{where, fmt::format("{}: found {}, expected {}", key.name, found, expected(key))};
  };
  const auto outcome = converted_to(key, node);
  if (const auto* wrong = std::get_if<WrongType>(&outcome))
    return problem(wrong->node->where, description(*wrong->node));
  const Value& value = std::get<Value>(outcome);
  if (const auto fault = fault_of(key, value))
    return problem(place_of(*fault, node), item_text(*fault));
  key.set(scene, rooted(key, value, folder));
  return std::nullopt;
}

/// The key of an entry, by its present or an old name, which is warned of; nullptr: there is none.
const Key* key_for(const Entry& entry, Reading& reading) {
  const std::string name = present_name(entry.name);
  const Key* key = known_key(reading, name);
  if (key != nullptr && name != entry.name)
    reading.warnings.push_back({entry.where, fmt::format("{} is the old name of {}; write {} = ...",
                                                         entry.name, name, leaf_of(name))});
  return key;
}

void apply(const Entry& entry, const fs::path& folder, Reading& reading) {
  const Key* key = key_for(entry, reading);
  if (key == nullptr) {
    reading.problems.push_back({entry.where, unknown_key_message(entry, reading)});
    return;
  }
  reading.places.given[key->name] = entry.where;
  if (auto problem = store(*key, entry.node, folder, reading.scene)) {
    reading.places.failed.insert(key->name);
    reading.problems.push_back(*problem);
  }
}

bool is_read_or_reported_with_its_table(const Entry& entry, const Reading& reading) {
  if (entry.table.empty()) return holds_items(entry);
  return !is_table(entry.table) && reading.places.given.count(entry.table) == 0;
}

/// A text cannot have a name twice, but a key by its old and by its present name.
void report_second_name(const Entry& entry, Reading& reading) {
  const std::string name = present_name(entry.name);
  const auto first = reading.places.given.find(name);
  if (first == reading.places.given.end()) return;
  reading.problems.push_back(
      {entry.where,
       fmt::format("{}: found the key again, by its {} name; line {} has it, expected "
                   "it once, as {}",
                   entry.name, entry.name == name ? "present" : "old", first->second.line, name)});
}

bool is_of_item(const Entry& entry, const Reading& reading) {
  return reading.item_keys.contains(present_name(entry.name));
}

/// An assignment of the command line, and what was wrong with it: said in the order that they stand
/// in there, whichever is applied first.
struct Override {
  std::optional<Entry> entry;
  std::vector<Problem> problems;
};

std::vector<Override> read_overrides(std::span<const std::string> texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    Override& override = overrides.emplace_back();
    try {
      override.entry = read_override(text);
    } catch (const InputError& error) {
      override.problems = error.problems();
    }
  }
  return overrides;
}

void apply(Override& override, Reading& reading) {
  const auto before = static_cast<std::ptrdiff_t>(reading.problems.size());
  apply(*override.entry, fs::path(), reading);
  const auto found = reading.problems.begin() + before;
  override.problems.assign(found, reading.problems.end());
  reading.problems.erase(found, reading.problems.end());
}

/// The keys of single tables, or those of items of arrays: the text's, then the command line's.
void apply_entries(const Document& document, std::span<Override> overrides, const fs::path& folder,
                   bool of_items, Reading& reading) {
  for (const Entry& entry : document.entries) {
    if (is_read_or_reported_with_its_table(entry, reading) ||
        is_of_item(entry, reading) != of_items)
      continue;
    report_second_name(entry, reading);
    apply(entry, folder, reading);
  }
  for (Override& override : overrides)
    if (override.entry && is_of_item(*override.entry, reading) == of_items)
      apply(override, reading);
}

/// Gives all items what single tables say for them.
void take_common(Scene& scene) {
  for (const TableArray& array : table_arrays()) {
    if (!array.take_common) continue;
    for (std::size_t item = 0; item < array.count(scene); ++item) array.take_common(scene, item);
  }
}

/// For who types a scene's name alone, or has a package and types what the manual says from where
/// there are no examples.
std::string hint_of_place(const fs::path& path) {
  std::error_code unreadable;
  const fs::path with_ending = path.string() + ".toml";
  if (fs::is_regular_file(with_ending, unreadable))
    return fmt::format("; did you mean {}?", with_ending.string());
  const fs::path shipped = bundled_folder("examples") / path.filename();
  if (path.parent_path() != "examples" || !fs::exists(shipped)) return {};
  return fmt::format("; the one that came with wold is {}", shipped.string());
}

/// The text of a file, but no more than a scene can have: it may be endless.
std::string bounded_text(const fs::path& path) {
  const auto unreadable = [&](const std::string& reason) {
    const SourcePosition where{path.string()};
    return InputError({Problem{where, "cannot read the scene file: " + reason}});
  };
  if (const std::string why = why_no_regular_file(path); !why.empty())
    throw unreadable(why + hint_of_place(path));
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw unreadable(errno == 0 ? "unknown reason" : std::strerror(errno));
  std::string text(largest_text_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw unreadable(errno == 0 ? "unknown reason" : std::strerror(errno));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

}  // namespace

LocatedScene parse_located_scene(std::string_view text, const std::string& file_name,
                                 std::span<const std::string> overrides) {
  const Document document = read_document(text, file_name);
  Reading reading;
  report_unknown_tables(document, reading);
  append_items(document, reading);
  std::vector<Override> assigned = read_overrides(overrides);
  const fs::path folder = fs::path(file_name).parent_path();
  apply_entries(document, assigned, folder, /*of_items=*/false, reading);
  take_common(reading.scene);
  apply_entries(document, assigned, folder, /*of_items=*/true, reading);
  for (const Override& override : assigned)
    reading.problems.insert(reading.problems.end(), override.problems.begin(),
                            override.problems.end());
  report_contradictions(reading.scene, reading.places, reading.problems);
  throw_problems(std::move(reading.problems));
  take_frames_of_shots(reading.scene);
  sort_by_line(reading.warnings);
  return {std::move(reading.scene), std::move(reading.places), std::move(reading.warnings)};
}

Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides) {
  return parse_located_scene(text, file_name, overrides).scene;
}

LocatedScene read_located_scene(const fs::path& path, std::span<const std::string> overrides) {
  return parse_located_scene(bounded_text(path), path.string(), overrides);
}

Scene read_scene(const fs::path& path, std::span<const std::string> overrides) {
  return read_located_scene(path, overrides).scene;
}

}  // namespace wold::scene
