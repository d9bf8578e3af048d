#pragma once

#include <variant>

#include "scene/document.h"
#include "scene/registry.h"

namespace wold::scene {

/// The node that has the wrong type, inside a list or the value itself.
struct WrongType {
  const Node* node;
};

/// The node as a value of the key's kind; ranges are not looked at. Whole numbers serve as
/// numbers, never the other way round.
std::variant<Value, WrongType> converted_to(const Key& key, const Node& node);

}  // namespace wold::scene
