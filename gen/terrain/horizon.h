#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold::terrain {

/// Elevation angle (radians, >= -pi/2) of the terrain's own horizon, seen from the ground at a
/// point towards a unit direction in the plane: the largest angle to the ground points on the way
/// to the map's border, taken every grid step and farther out every `spacing` times the distance.
/// What is narrower than that can be missed.
double horizon_rad(const Heightfield& terrain, const glm::dvec2& from_m,
                   const glm::dvec2& direction, double spacing);

/// Whether the ground rises above the straight line between two points, looked at every grid step.
bool is_hidden(const Heightfield& terrain, const glm::dvec3& from_m, const glm::dvec3& to_m);

}  // namespace wold::terrain
