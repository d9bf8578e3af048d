#pragma once

#include <cstdint>

#include "core/ground_map.h"

namespace wold::snow {

/// Where the ground's texture is white under [He2007]'s growing noise (section 3), 0 or 1, on a
/// map of `samples` >= 2 along a side, when the noise has the strength gamma in [0, 1]. The
/// ground's shape stays as it is, and white texels stay white while gamma grows.
///
/// Noise is white dots of one texel, gamma phi of them per m2 of a facet, in units of four per
/// texel of the whole texture; phi = S_texture / S_scene is the facet's texture area over its area
/// on the ground (steps 4 and 5). That is what phi is for: a facet has S_texture of the texels, so
/// that each of them is hit by gamma phi S_scene / S_texture = gamma units of dots, 4 gamma in the
/// mean, whatever the facet's size, slope and texture. By Poisson's law the fraction 1 - exp(-4
/// gamma) is white, 98 % at last. Facets, which only carry phi, leave no other trace; none of a
/// terrain's hangs over (steps 2 and 3).
FactorMap paper_white(double size_m, double gamma, int samples, std::uint64_t seed);

}  // namespace wold::snow
