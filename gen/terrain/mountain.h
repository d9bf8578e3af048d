#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::terrain {

/// The procedural mountain, `hill_height_m` high: its summit stands north of the middle, at (0.52,
/// 0.62) of the side or near it; ridges and valleys branch down from it to low ground at the
/// borders. Along the south border, up to about 15 % of the side, lies a meadow that rises gently
/// northwards: from there one looks up at the mountain.
///
/// Rock rises and streams cut it (Cordonnier et al. 2016; streams.h), first on a coarse grid, then
/// on finer ones while the land rises by what is worn off it: grids of their own, so that the same
/// seed is the same mountain for any number of samples. On it lies fractal relief
/// (fBm of unit deviation times relief_m); what is steeper than the talus angle slides, and soil
/// creeps (crept()). Then the highest point is raised again to its height. A mountain a third as
/// high as its square is wide keeps its ridges with a talus angle of about 60 degrees; with less
/// than 50 its faces slide to plane slopes.
/// Heights in metres; the same for any number of threads.
Heightfield make_mountain(const scene::Terrain& terrain, std::uint64_t seed);

}  // namespace wold::terrain
