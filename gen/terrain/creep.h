#pragma once

#include "core/ground_map.h"

namespace wold::terrain {

/// Soil creep (Culling 1960): dz/dt = D laplacian(z), with `length2_m2` = D t. Waves of wavelength
/// L keep exp(-4 pi^2 length2_m2 / L^2) of their height. Nothing flows across the map's border, so
/// that the mean height stays to rounding; level ground stays level. Heights are doubles because
/// floats would hide a loss. The same for any number of threads.
void creep(GroundMap<double>& heights_m, double length2_m2);

/// The ground when soil has crept until what is finer than about a metre is gone (2 % of waves of
/// 1 m are left, 64 % of 3 m): a flat cell of grass fits it.
Heightfield crept(GroundMap<double> heights_m);

}  // namespace wold::terrain
