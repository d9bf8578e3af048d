#pragma once

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::test {

/// Grass everywhere on the scene's ground.
inline FactorMap grown(const scene::Scene& scene) { return {2, scene.terrain.size_m, 1.0F}; }

}  // namespace wold::test
