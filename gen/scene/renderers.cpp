#include "scene/renderers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace wold::scene {
namespace {

/// Each exporter's name, in the order of film/exporters.cpp.
constexpr std::array exporter_names = {"blender", "povray", "mitsuba", "usd"};

constexpr const char* both = "both";
constexpr std::array both_names = {"blender", "povray"};

bool has(const auto& words, std::string_view word) { return std::ranges::count(words, word) > 0; }

bool are_both(const std::vector<std::string>& names) {
  return std::ranges::equal(names, both_names);
}

}  // namespace

std::vector<std::string> renderer_words() {
  std::vector<std::string> words;
  words.reserve(exporter_names.size() + 1);
  for (const char* name : exporter_names) words.emplace_back(name);
  words.emplace_back(both);
  return words;
}

std::vector<std::string> renderers_of(const Value& value) {
  const auto* word = std::get_if<std::string>(&value);
  const std::vector<std::string> words =
      word ? std::vector{*word} : std::get<std::vector<std::string>>(value);
  std::vector<std::string> names;
  for (const char* name : exporter_names)
    if (has(words, name) || (has(words, both) && has(both_names, name))) names.emplace_back(name);
  return names;
}

Value renderers_value(const std::vector<std::string>& names) {
  if (names.size() == 1) return names.front();
  if (are_both(names)) return std::string(both);
  return names;
}

std::string renderers_text(const std::vector<std::string>& names) {
  return are_both(names) ? both : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace wold::scene
