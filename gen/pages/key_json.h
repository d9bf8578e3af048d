#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/registry.h"

/// Keys of the scene file and their values as JSON.
namespace wold::pages {

/// A value as JSON has it: "auto" where an automatic number has none, a curve as its name or as its
/// points [weathering degree, value].
nlohmann::ordered_json json_of(const scene::Value& value);

/// What a key accepts, as JSON Schema (draft 2020-12).
nlohmann::ordered_json accepted_by(const scene::Key& key);

}  // namespace wold::pages
