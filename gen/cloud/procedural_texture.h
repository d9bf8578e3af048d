#pragma once

#include <cstdint>

#include "cloud/periodic_map.h"
#include "cloud/recipe.h"

namespace wold::cloud {

/// How many octaves of a noise a texture of side_px pixels shows: those whose features have at
/// least three along their shorter side, and always the first. In [1, octaves.count].
int octaves_in_map(const Octaves& octaves, int side_px);

/// A texture's field: the higher, the more cloud; only the order of its values means something.
/// Periodic Perlin-Worley noise (Schneider 2015, The real-time volumetric cloudscapes of Horizon
/// Zero Dawn), in two dimensions: gradient noise says where clouds stand, inverted cellular noise
/// heaps round heads on them, gradient noise displaces both. Ice trails behind (trails.h). Keyed by
/// `key`, side_px >= 1.
PeriodicMap<float> procedural_field(const Recipe& recipe, int side_px, std::uint64_t key);

/// The field at a place, in textures, without trails: f(x + 1, y) = f(x, y + 1) = f(x, y), to the
/// bit where the places are exact in binary.
double procedural_field_at(const Recipe& recipe, const glm::dvec2& place, std::uint64_t key);

}  // namespace wold::cloud
