#pragma once

#include "cloud/periodic_map.h"

namespace wold::cloud {

/// Means over squares of 2 radius + 1 pixels about every pixel, radius >= 0; the map continues at
/// its other side. Twice gives a smooth kernel.
PeriodicMap<float> box_filtered(const PeriodicMap<float>& map, int radius);

}  // namespace wold::cloud
