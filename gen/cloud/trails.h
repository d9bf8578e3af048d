#pragma once

#include <cstdint>

#include "cloud/periodic_map.h"
#include "cloud/recipe.h"

namespace wold::cloud {

/// Ice over each place of a texture, as a logarithm: the sum of what heads up its path let fall,
/// which fades by e over trails.length as it sublimes. Heads drift with the wind at their height
/// and leave what falls behind, so that a trail lies upwind of its head (Heymsfield 1975, Cirrus
/// uncinus generating cells and the evolution of cirriform clouds). `heads`: a field of deviation 1
/// or so; where it is 1 higher, exp(trails.contrast) times as much ice falls. All trails of a
/// region bend alike, as the wind turns with height, and turbulence makes them undulate; regions
/// and waves differ, keyed by `key`. Falling ice spreads: far from its head a trail is wider.
PeriodicMap<float> trailing(const PeriodicMap<float>& heads, const Trails& trails,
                            std::uint64_t key);

}  // namespace wold::cloud
