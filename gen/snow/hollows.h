#pragma once

#include "core/ground_map.h"

namespace wold::snow {

/// How hollow a terrain's ground is, on a map of its samples: how much higher it is on the mean
/// `feature_m` (at least one of the terrain's steps) to all sides, over the standard deviation of
/// that. Above 0 in hollows, below on humps, 0 where it is level and at the border.
FactorMap hollows(const Heightfield& terrain, double feature_m);

}  // namespace wold::snow
