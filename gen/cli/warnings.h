#pragma once

#include "scene/scene.h"

namespace wold::cli {

/// Says on stderr what advice::scene_warnings() has to say about a film.
void print_warnings(const scene::Scene& film);

}  // namespace wold::cli
