#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/registry.h"

namespace wold::scene {

/// The key of that name, "sun.elevation" or "clouds.kind", or all keys of a table: "sun", "clouds";
/// of a table that may stand many times those of its first item; "" is all keys. An old name is
/// taken for the present one. Throws InputError, with the name that may have been meant, when there
/// is no such key or table.
std::vector<Key> keys_named(std::string_view name);

/// What the keys_named() mean, what they accept and their defaults, as TOML that a scene can take;
/// of "" the names alone, a line for each table.
std::string explanation(std::string_view name);

}  // namespace wold::scene
