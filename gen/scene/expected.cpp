#include <fmt/format.h>

#include "scene/registry.h"

/// What a key accepts, in words.
namespace wold::scene {
namespace {

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 == items.size() ? " or " : ", ";
    text += items[i];
  }
  return text;
}

std::string words_text(const Key& key) {
  std::vector<std::string> words;
  for (const std::string& word : key.words) words.push_back('"' + word + '"');
  return alternatives(words);
}

std::string members_text(const Key& key) {
  std::vector<std::string> members;
  for (const std::int64_t member : key.members) members.push_back(std::to_string(member));
  return alternatives(members);
}

std::string range_text(const Key& key) {
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  if (!key.members.empty()) return members_text(key) + unit;
  return fmt::format("from {} to {}{}", key.lowest, key.highest, unit);
}

std::string order_text(Order order) {
  switch (order) {
    case Order::any:
      return {};
    case Order::increasing:
      return ", each larger than the one before";
    case Order::decreasing:
      return ", each smaller than the one before";
    case Order::not_falling:
      return ", none smaller than the one before";
  }
  return {};
}

std::string curve_text(const Key& key) {
  return fmt::format(
      "{}, or a list of {} to {} points [weathering degree, value], the degree rising from 0 to 1, "
      "values from {} to {}{}",
      words_text(key), key.points.min_items, key.points.max_items, key.lowest, key.highest,
      order_text(key.points.order));
}

std::string list_text(const Key& key, const char* items) {
  const ListRule& rule = key.list;
  std::string text = rule.min_items == rule.max_items
                         ? fmt::format("{} {} {}", rule.min_items, items, range_text(key))
                         : fmt::format("a list of {} to {} {} {}", rule.min_items, rule.max_items,
                                       items, range_text(key));
  text += order_text(rule.order);
  if (rule.spans_range)
    text += fmt::format(", the first {} and the last {}", key.lowest, key.highest);
  return text;
}

}  // namespace

std::string expected(const Key& key) {
  switch (key.kind) {
    case Kind::integer:
      return key.members.empty() ? "a whole number " + range_text(key) : range_text(key);
    case Kind::number:
      return "a number " + range_text(key);
    case Kind::automatic:
      return fmt::format("a number {}, or \"{}\"", range_text(key), automatic_word);
    case Kind::files:
      return fmt::format("a list of {} to {} paths of files", key.list.min_items,
                         key.list.max_items);
    case Kind::name:
      return "a file name of 1 to 64 letters, digits, '_', '-' and '.' that starts with a letter "
             "or digit";
    case Kind::file:
      return "the path of a file, or \"\"";
    case Kind::system:
      return "\"EPSG:\" and a number of up to 6 digits, such as \"EPSG:4326\", or \"\"";
    case Kind::word:
    case Kind::words:
      return words_text(key);
    case Kind::integers:
      return list_text(key, "whole numbers");
    case Kind::numbers:
      return list_text(key, "numbers");
    case Kind::curve:
      return curve_text(key);
    case Kind::curves:
      return fmt::format("a list of {} to {} curves, each {}", key.list.min_items,
                         key.list.max_items, curve_text(key));
  }
  return {};
}

}  // namespace wold::scene
