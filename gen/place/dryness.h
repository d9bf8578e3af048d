#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold::place {

/// How dry the ground is for its place in the relief, mean 0 and standard deviation 1, cut at 2.5:
/// by the water that gathers there and by the sun on it, which count alike on mountains. Water is
/// the topographic wetness index ln(a / tan b) (Beven and Kirkby 1979), a the area that drains
/// through a metre of contour and b the slope: spurs and steep slopes are dry, hollows and valley
/// floors wet. The sun is sun_over_level() for `sun`. On at most 513 samples along a side.
FactorMap dryness_map(const Heightfield& terrain, const glm::dvec3& sun);

}  // namespace wold::place
