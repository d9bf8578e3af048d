#pragma once

#include <cstdint>

#include "grass/texel/points.h"

namespace wold::grass {

/// The last act of a step of Algorithm 1: of the points of blade `blade` those of one tissue that
/// are nearer than `distance_m` to each other become one, whose attributes are their means by area.
/// It bears their whole area; the other one stays in its place without any.
void merge_points(Points& points, std::size_t blade, float distance_m);

}  // namespace wold::grass
