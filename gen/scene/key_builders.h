#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/registry.h"

/// Keys by their kinds, still without their fields (binding.h).
namespace wold::scene {

/// Ends included.
struct Range {
  double lowest;
  double highest;
};

inline Key plain(Kind kind, std::string name, const char* unit, Range range, const char* doc) {
  return {.name = std::move(name),
          .unit = unit,
          .doc = doc,
          .kind = kind,
          .lowest = range.lowest,
          .highest = range.highest,
          .words = {},
          .members = {},
          .list = {},
          .points = {},
          .get = {},
          .set = {}};
}

inline Key number(std::string name, const char* unit, Range range, const char* doc) {
  return plain(Kind::number, std::move(name), unit, range, doc);
}

inline Key integer(std::string name, const char* unit, Range range, const char* doc) {
  return plain(Kind::integer, std::move(name), unit, range, doc);
}

/// A key whose field is a Mode; the words come from there when the key is bound to it.
inline Key word(std::string name, const char* doc) {
  return plain(Kind::word, std::move(name), "", {0, 0}, doc);
}

inline Key word(std::string name, std::vector<std::string> words, const char* doc) {
  Key key = plain(Kind::word, std::move(name), "", {0, 0}, doc);
  key.words = std::move(words);
  return key;
}

/// A word, or a list of some of the words.
inline Key words(std::string name, std::vector<std::string> words, const char* doc) {
  Key key = word(std::move(name), std::move(words), doc);
  key.kind = Kind::words;
  key.list = {.min_items = 1, .max_items = key.words.size()};
  return key;
}

inline Key curve(std::string name, std::vector<std::string> words, const char* doc) {
  Key key = plain(Kind::curve, std::move(name), "", {0, 1}, doc);
  key.words = std::move(words);
  key.points = {.min_items = 2, .max_items = 1000};
  return key;
}

inline Key rates(std::string name, std::vector<std::string> words, std::size_t max,
                 const char* doc) {
  Key key = curve(std::move(name), std::move(words), doc);
  key.kind = Kind::curves;
  key.list = {.min_items = 0, .max_items = max};
  key.points.order = Order::not_falling;
  return key;
}

inline Key list(Kind kind, std::string name, const char* unit, Range range, ListRule rule,
                const char* doc) {
  Key key = plain(kind, std::move(name), unit, range, doc);
  key.list = rule;
  return key;
}

inline Key only(Key key, std::vector<std::int64_t> members) {
  key.members = std::move(members);
  return key;
}

/// A number, or "auto".
inline Key automatic(std::string name, const char* unit, Range range, const char* doc) {
  return plain(Kind::automatic, std::move(name), unit, range, doc);
}

}  // namespace wold::scene
