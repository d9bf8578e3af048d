#pragma once

#include <string>
#include <string_view>

namespace wold::pages {

/// What scene::explanation() says, as JSON: {"version": 1, "keys": [...]}, of each key its name,
/// unit, meaning, what it accepts in words and as JSON Schema, its default, and whether its table
/// may stand many times. Throws what scene::keys_named() does.
std::string explanation_json(std::string_view name);

}  // namespace wold::pages
