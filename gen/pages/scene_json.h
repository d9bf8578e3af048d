#pragma once

#include <string>

#include "scene/scene.h"

namespace wold::pages {

/// A scene as JSON: {"version": 1, "scene": {...}} with every key's value, in the tables and under
/// the names of the scene file; a table that may stand many times is an array. Names of files that
/// are no text have replacement characters.
std::string scene_json(const scene::Scene& scene);

}  // namespace wold::pages
