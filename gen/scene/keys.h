#pragma once

#include <vector>

#include "scene/registry.h"

namespace wold::scene {

/// The registry's entries, one function per table of the scene file.
std::vector<Key> top_level_keys();
std::vector<Key> terrain_keys();
std::vector<Key> growth_keys();
std::vector<Key> grass_keys();
std::vector<Key> ageing_keys();
std::vector<Key> fur_keys();
std::vector<Key> sun_keys();
std::vector<Key> sky_keys();
std::vector<Key> wind_keys();
std::vector<Key> camera_keys();
std::vector<Key> render_keys();

}  // namespace wold::scene
