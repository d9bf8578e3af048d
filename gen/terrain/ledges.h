#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/surface.h"

namespace wold::terrain {

/// Share of the ground on which snow can lie, in [0, 1], on the surface's grid: of rock, which
/// shows beyond terrain.rock_slope where no grass grows, its ledges, sooner in gullies than on
/// spurs; all of other ground. `growth` in [0, 1]. 1 at places that do not count.
FactorMap ledges(const Surface& surface, const FactorMap& growth, const scene::Terrain& look,
                 std::uint64_t seed);

}  // namespace wold::terrain
