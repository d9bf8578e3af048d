#pragma once

#include <glm/glm.hpp>

namespace wold {

/// CIE 1976 L*a*b* of XYZ (Y = 1 for white) under D65 (ISO/CIE 11664-4): L* from 0 to 100.
glm::dvec3 lab_from_xyz(const glm::dvec3& xyz);

/// CIEDE2000 difference of two L*a*b* colours, all weights 1; about 1 is just noticeable (Sharma,
/// Wu and Dalal 2005, Color Research and Application 30:21).
double colour_difference(const glm::dvec3& lab, const glm::dvec3& other);

}  // namespace wold
