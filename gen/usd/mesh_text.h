#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>

namespace wold::usd {

/// Lowest and highest corner of the box around some points, as an extent. At least one point.
std::string extent_text(std::span<const glm::vec3> points_m);

/// faceVertexCounts of so many quadrilaterals.
std::string quad_counts(std::size_t quads);

}  // namespace wold::usd
