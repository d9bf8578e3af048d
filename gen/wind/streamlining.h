#pragma once

#include <glm/glm.hpp>

namespace wold::wind {

/// The angle that a blade leans by under a load which would bend it by `load` radians if it did not
/// turn out of the wind, radians in [0, pi / 2): what pushes it is the part that meets its side,
///   theta = load cos^2 theta ([Gosselin2010], [Vogel1989]), so that it never lies flat.
double leaning_rad(double load);

/// The load under which a blade leans so.
double load_of(double leaning_rad);

/// What leans so far as `lean`, metres along the ground per metre of height, under a further load,
/// radians, both east and north.
glm::dvec2 leaning_under(const glm::dvec2& lean, const glm::dvec2& load);

}  // namespace wold::wind
