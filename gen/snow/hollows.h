#pragma once

#include "core/ground_map.h"

namespace wold::snow {

/// How hollow a terrain's ground is within `feature_m` on all sides, over the deviation of that on
/// the map: above 0 in hollows, below on humps, 0 where it is level and at the border.
FactorMap hollows(const Heightfield& terrain, double feature_m);

}  // namespace wold::snow
