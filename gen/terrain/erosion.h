#pragma once

#include "core/ground_map.h"

namespace wold::terrain {

// Both move material between pairs of samples: what one gives, the other receives, so the mean
// height stays to rounding. Heights are doubles because floats would hide a loss. Level ground
// stays level. The same for any number of threads.

/// Thermal erosion (Musgrave, Kolb and Mace 1989): what is steeper than the talus angle slides to
/// the lower of two neighbours, diagonal ones included, a fixed fraction of the excess in each of
/// `steps` exchanges. A fifth of them each spans 16, 8, 4, 2 and 1 grid steps, so that large slopes
/// settle too.
void slide(GroundMap<double>& heights_m, double talus_deg, int steps);

/// Soil creep (Culling 1960): dz/dt = D laplacian(z), with `length2_m2` = D t. Waves of wavelength
/// L keep exp(-4 pi^2 length2_m2 / L^2) of their height. No flow across the map's border.
void creep(GroundMap<double>& heights_m, double length2_m2);

/// The ground when soil has crept until what is finer than about a metre is gone (2 % of waves of
/// 1 m are left, 64 % of 3 m): a flat cell of grass fits it.
Heightfield crept(GroundMap<double> heights_m);

}  // namespace wold::terrain
