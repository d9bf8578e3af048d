#pragma once

#include <string>

namespace wold::pages {

/// The scene file as JSON Schema (draft 2020-12), for editors that complete and check TOML by it:
/// every table and key with its meaning, unit, range, words and default. Keys that were renamed are
/// in it as deprecated ones. What one key asks of another is left to `wold check`, and so is the
/// order of a list.
std::string scene_schema();

}  // namespace wold::pages
