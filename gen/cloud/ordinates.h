#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>

namespace wold::cloud {

/// Directions that stand for all: means over the sphere are those over them. The level-symmetric
/// set S4 (Lathrop and Carlson 1965, Discrete ordinates angular quadrature of the neutron transport
/// equation), in which each counts alike. Means of products of up to five components are exact.
inline constexpr int ordinate_count = 24;

/// Unit vectors.
const std::array<glm::dvec3, ordinate_count>& ordinates();

/// Radiance that comes to a place, by the ordinate that it travels along.
using ArrivingRadiance = std::array<glm::vec3, ordinate_count>;

/// The means of radiance_from, which is asked with the unit vectors that it comes from, over the
/// directions that are nearest to each ordinate.
ArrivingRadiance arriving_radiance(
    const std::function<glm::vec3(const glm::dvec3& direction)>& radiance_from);

}  // namespace wold::cloud
