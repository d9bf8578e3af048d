#pragma once

#include <glm/glm.hpp>

namespace wold {

/// CIEDE2000 difference of two L*a*b* colours, all weights 1; about 1 is just noticeable (Sharma,
/// Wu and Dalal 2005, Color Research and Application 30:21).
double colour_difference(const glm::dvec3& lab, const glm::dvec3& other);

}  // namespace wold
