#pragma once

#include "core/ground_map.h"

namespace wold::place {

/// How dry the ground is for its place in the relief: the topographic wetness index ln(a / tan b)
/// (Beven and Kirkby 1979), a the area that drains through a metre of contour and b the slope, with
/// its sign turned, mean 0 and standard deviation 1, cut at 2.5. Spurs and steep slopes are dry,
/// hollows and valley floors wet. On at most 513 samples along a side.
FactorMap dryness_map(const Heightfield& terrain);

}  // namespace wold::place
