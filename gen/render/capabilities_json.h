#pragma once

#include <nlohmann/json_fwd.hpp>

#include "render/capabilities.h"

namespace wold::render {

/// As wold_render.py --probe and `wold doctor --json` have them: "version", "python", "volumes",
/// "fog", "nanovdb" (null: not known), "devices" of "type" and "name", "threads".
nlohmann::json to_json(const Capabilities& capabilities);

/// The same back; other members do no harm. Throws nlohmann::json::exception when one is missing or
/// of another type.
Capabilities capabilities_of(const nlohmann::json& json);

}  // namespace wold::render
