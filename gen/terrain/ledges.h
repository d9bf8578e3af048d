#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/surface.h"

namespace wold::terrain {

/// Share of the ground on which snow can lie, in [0, 1], on the surface's grid: of ground beyond
/// terrain.rock_slope the ledges of its rock, sooner in gullies than on spurs; all of what is less
/// steep. 1 at places that do not count.
FactorMap ledges(const Surface& surface, const scene::Terrain& look, std::uint64_t seed);

}  // namespace wold::terrain
