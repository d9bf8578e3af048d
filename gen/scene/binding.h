#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/registry.h"

/// How a key reaches its field of Scene: between the field's own C++ type and Value.
namespace wold::scene {

template <class T>
concept PlainField = std::same_as<T, double> || std::same_as<T, std::string> ||
    std::same_as<T, CurveChoice> || std::same_as<T, std::vector<CurveChoice>> ||
    std::same_as<T, std::optional<double>> || std::same_as<T, std::vector<std::string>>;

template <class T>
using ItemsOf = std::vector<
    std::conditional_t<std::is_integral_v<typename T::value_type>, std::int64_t, double>>;

/// All words of a mode, in the order of its enumerators.
template <Mode T>
std::vector<std::string> all_words() {
  constexpr auto words = words_of(T{});
  return {words.begin(), words.end()};
}

/// The mode of a word. Throws std::invalid_argument for a word that is none of its.
template <Mode T>
T mode_of(const std::string& word) {
  const std::vector<std::string> words = all_words<T>();
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) throw std::invalid_argument("no mode is called " + word);
  return static_cast<T>(found - words.begin());
}

template <class T>
Value value_of(const T& field) {
  if constexpr (std::integral<T>)
    return static_cast<std::int64_t>(field);
  else if constexpr (Mode<T>)
    return std::string(word_of(field));
  else if constexpr (PlainField<T>)
    return field;
  else
    return ItemsOf<T>(field.begin(), field.end());
}

template <class T>
void assign(T& field, const Value& value) {
  if constexpr (std::integral<T>) {
    field = static_cast<T>(std::get<std::int64_t>(value));
  } else if constexpr (Mode<T>) {
    field = mode_of<T>(std::get<std::string>(value));
  } else if constexpr (PlainField<T>) {
    field = std::get<T>(value);
  } else {
    const auto& items = std::get<ItemsOf<T>>(value);
    if constexpr (requires { field.resize(items.size()); }) field.resize(items.size());
    std::transform(items.begin(), items.end(), field.begin(),
                   [](auto item) { return static_cast<typename T::value_type>(item); });
  }
}

/// Gives the key its accessors and, of a mode, its words; `field` is a generic lambda from a Scene
/// to a reference.
template <class Field>
Key bound(Key key, Field field) {
  using T = std::remove_cvref_t<std::invoke_result_t<Field, Scene&>>;
  if constexpr (Mode<T>) key.words = all_words<T>();
  key.get = [field](const Scene& scene) { return value_of(field(scene)); };
  key.set = [field](Scene& scene, const Value& value) { assign(field(scene), value); };
  return key;
}

}  // namespace wold::scene
