#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace wold::scene {

/// Names of keys, in any order.
using KeyNames = std::vector<std::string_view>;

/// Those of two lists.
KeyNames joined(KeyNames names, const KeyNames& more);

/// A kind of starter scene: what it shows, its values, and the keys that it has besides those of
/// every kind.
struct Starter {
  std::string kind;
  std::string title;
  Scene scene;
  KeyNames keys;
};

/// All kinds there are, "hillside" first.
const std::vector<Starter>& starters();

}  // namespace wold::scene
