#include "scene/parse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <tuple>

#include "core/error.h"
#include "scene/consistency.h"
#include "scene/convert.h"
#include "scene/document.h"
#include "scene/nearest.h"
#include "scene/registry.h"
#include "scene/text.h"

namespace wold::scene {
namespace fs = std::filesystem;
namespace {

bool is_table(std::string_view name) {
  return std::find(tables().begin(), tables().end(), name) != tables().end();
}

/// What the passes work on.
struct Reading {
  Scene scene;
  Places places;
  std::vector<Problem> problems;
};

void report_unknown_tables(const Document& document, Reading& reading) {
  for (const Section& section : document.sections) {
    if (is_table(section.name)) continue;
    const Key* key = find_key(section.name);
    reading.problems.push_back(
        {section.where,
         key != nullptr ? fmt::format("{}: found a table, expected {}", key->name, expected(*key))
                        : fmt::format("unknown table [{}]{}", shown(section.name),
                                      suggestion(nearest_table(section.name)))});
  }
}

std::string unknown_key_message(const Entry& entry) {
  if (is_table(entry.name))
    return fmt::format("{}: found {}, expected the table [{}]", entry.name, description(entry.node),
                       entry.name);
  return fmt::format("unknown key {}{}", in_quotes(entry.name),
                     suggestion(nearest_key(entry.name)));
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

/// The value of a key that holds a path, made absolute: relative ones start at `folder`.
Value rooted(const Key& key, const Value& value, const fs::path& folder) {
  const auto* text = std::get_if<std::string>(&value);
  if (key.kind != Kind::file || text == nullptr || text->empty()) return value;
  return fs::absolute(folder / *text).lexically_normal().string();
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

void apply(const Entry& entry, const fs::path& folder, Reading& reading) {
  const Key* key = find_key(entry.name);
  if (key == nullptr) {
    reading.problems.push_back({entry.where, unknown_key_message(entry)});
    return;
  }
  reading.places.given[key->name] = entry.where;
  if (auto problem = store(*key, entry.node, folder, reading.scene)) {
    reading.places.failed.insert(key->name);
    reading.problems.push_back(*problem);
  }
}

void apply_entries(const Document& document, const fs::path& folder, Reading& reading) {
  for (const Entry& entry : document.entries) {
    const bool reported_with_its_table = !entry.table.empty() && !is_table(entry.table);
    if (!reported_with_its_table) apply(entry, folder, reading);
  }
}

void apply_override(const std::string& text, Reading& reading) {
  try {
    apply(read_override(text), fs::path(), reading);
  } catch (const InputError& error) {
    reading.problems.insert(reading.problems.end(), error.problems().begin(),
                            error.problems().end());
  }
}

/// The text's problems from its top, then those without a line.
void sort_by_line(std::vector<Problem>& problems) {
  const auto rank = [](const Problem& problem) {
    return std::tuple(problem.where.line == 0, problem.where.line, problem.where.column);
  };
  std::ranges::stable_sort(problems, {}, rank);
}

/// The text of a file, but no more than a scene can have: it may be endless.
std::string bounded_text(const fs::path& path) {
  const auto unreadable = [&](const std::string& reason) {
    const SourcePosition where{path.string()};
    return InputError({Problem{where, "cannot read the scene file: " + reason}});
  };
  std::error_code error;
  if (fs::is_directory(path, error)) throw unreadable("it is a folder");
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

Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides) {
  const Document document = read_document(text, file_name);
  Reading reading;
  report_unknown_tables(document, reading);
  apply_entries(document, fs::path(file_name).parent_path(), reading);
  for (const std::string& override_text : overrides) apply_override(override_text, reading);
  report_contradictions(reading.scene, reading.places, reading.problems);
  sort_by_line(reading.problems);
  if (!reading.problems.empty()) throw InputError(std::move(reading.problems));
  return reading.scene;
}

Scene read_scene(const fs::path& path, std::span<const std::string> overrides) {
  return parse_scene(bounded_text(path), path.string(), overrides);
}

}  // namespace wold::scene
