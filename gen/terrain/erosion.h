#pragma once

#include "core/ground_map.h"

namespace wold::terrain {

/// Thermal erosion (Musgrave, Kolb and Mace 1989): what is steeper than the talus angle slides to
/// the lower of two neighbours, diagonal ones included, a fixed fraction of the excess in each of
/// `steps` exchanges. A fifth of them each spans 16, 8, 4, 2 and 1 grid steps, so that large slopes
/// settle too. What one sample gives, another receives, so that the mean height stays to rounding.
/// Heights are doubles because floats would hide a loss. Level ground stays level. The same for any
/// number of threads.
void slide(GroundMap<double>& heights_m, double talus_deg, int steps);

}  // namespace wold::terrain
