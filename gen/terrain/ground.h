#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::terrain {

/// The scene's ground: make_hillside(), or the place of an elevation model when it names one
/// (elevation.h).
///
/// What was measured stays; below the model's cells the scene's fractal relief goes on, as high
/// there as that relief is at this size (deviation falls with size to the power of the roughness),
/// and soil creeps (crept()). Heights in metres; the same for any
/// number of threads. Throws what read_elevation() throws.
Heightfield make_ground(const scene::Terrain& terrain, std::uint64_t seed);

}  // namespace wold::terrain
