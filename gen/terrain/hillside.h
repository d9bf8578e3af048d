#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::terrain {

/// The procedural hillside: it rises northwards from the near edge (y = 0) to a rounded crest at
/// 72 % of the side and falls behind it, so that the crest is the skyline for somebody who stands
/// at the near edge; towards the east and west edges it falls as well. On it lies fractal relief
/// (fBm of unit deviation times relief_m); what is steeper than the talus angle slides, and soil
/// creeps (crept()).
/// Heights in metres; the same for any number of threads.
Heightfield make_hillside(const scene::Terrain& terrain, std::uint64_t seed);

}  // namespace wold::terrain
