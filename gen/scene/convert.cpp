#include "scene/convert.h"

#include <optional>

namespace wold::scene {
namespace {

using Outcome = std::variant<Value, WrongType>;

const std::vector<Node>* items_of(const Node& node) {
  return std::get_if<std::vector<Node>>(&node.value);
}

template <class T>
std::optional<T> scalar(const Node& node) {
  if (const T* value = std::get_if<T>(&node.value)) return *value;
  return std::nullopt;
}

template <>
std::optional<double> scalar<double>(const Node& node) {
  if (const auto* integer = std::get_if<std::int64_t>(&node.value))
    return static_cast<double>(*integer);
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  return std::nullopt;
}

template <class T>
Outcome one(const Node& node) {
  if (const auto value = scalar<T>(node)) return *value;
  return WrongType{&node};
}

Outcome number_or_auto(const Node& node) {
  if (scalar<std::string>(node) == automatic_word) return std::optional<double>();
  if (const auto value = scalar<double>(node)) return std::optional<double>(*value);
  return WrongType{&node};
}

template <class T>
Outcome many(const Node& node) {
  const auto* items = items_of(node);
  if (items == nullptr) return WrongType{&node};
  std::vector<T> values;
  for (const Node& item : *items) {
    const auto value = scalar<T>(item);
    if (!value) return WrongType{&item};
    values.push_back(*value);
  }
  return values;
}

std::optional<glm::dvec2> point(const Node& node) {
  const auto* pair = items_of(node);
  if (pair == nullptr || pair->size() != 2) return std::nullopt;
  const auto x = scalar<double>((*pair)[0]);
  const auto y = scalar<double>((*pair)[1]);
  if (!x || !y) return std::nullopt;
  return glm::dvec2(*x, *y);
}

Outcome one_or_many(const Node& node) {
  return items_of(node) == nullptr ? one<std::string>(node) : many<std::string>(node);
}

Outcome curve(const Node& node) {
  if (const auto name = scalar<std::string>(node)) return CurveChoice{*name, {}};
  const auto* items = items_of(node);
  if (items == nullptr || items->empty()) return WrongType{&node};
  CurveChoice choice;
  for (const Node& item : *items) {
    const auto next = point(item);
    if (!next) return WrongType{&item};
    choice.points.push_back(*next);
  }
  return choice;
}

Outcome curves(const Node& node) {
  const auto* items = items_of(node);
  if (items == nullptr) return WrongType{&node};
  std::vector<CurveChoice> choices;
  for (const Node& item : *items) {
    const Outcome outcome = curve(item);
    if (const auto* wrong = std::get_if<WrongType>(&outcome)) return *wrong;
    choices.push_back(std::get<CurveChoice>(std::get<Value>(outcome)));
  }
  return choices;
}

}  // namespace

Outcome converted_to(const Key& key, const Node& node) {
  switch (key.kind) {
    case Kind::integer:
      return one<std::int64_t>(node);
    case Kind::number:
      return one<double>(node);
    case Kind::automatic:
      return number_or_auto(node);
    case Kind::files:
      return many<std::string>(node);
    case Kind::name:
    case Kind::word:
    case Kind::file:
    case Kind::system:
      return one<std::string>(node);
    case Kind::words:
      return one_or_many(node);
    case Kind::integers:
      return many<std::int64_t>(node);
    case Kind::numbers:
      return many<double>(node);
    case Kind::curve:
      return curve(node);
    case Kind::curves:
      return curves(node);
  }
  return WrongType{&node};
}

}  // namespace wold::scene
