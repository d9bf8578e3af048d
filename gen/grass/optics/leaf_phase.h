#pragma once

#include <glm/glm.hpp>

namespace wold::grass {

/// A direction as it is seen along a fibre of unit `tangent`: its part across the fibre, of unit
/// length; nothing along the fibre itself.
glm::vec3 seen_along(const glm::vec3& tangent, const glm::vec3& direction);

/// What a leaf sends to an eye over what it sends on average to all directions, for its reflectance
/// and for its transmittance: each has a mean of 1.
struct LeafPhase {
  float reflected;
  float transmitted;
};

/// Of light from one direction: a flat leaf that is turned about its axis by any angle, its two
/// sides Lambert's. With psi the angle between light and eye, both seen along the axis, it is pi /
/// 4 ((pi - psi) cos psi + sin psi) for what is reflected, the same of pi - psi for what is
/// transmitted: a leaf is bright with the light behind the eye and against the light, darker
/// across. The three directions are unit, away from the leaf.
LeafPhase leaf_phase(const glm::vec3& tangent, const glm::vec3& light, const glm::vec3& view);

}  // namespace wold::grass
