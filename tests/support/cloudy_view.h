#pragma once

#include "landscape/landscape.h"

namespace wold::test {

/// Makes a landscape one of nothing but an even cloud in the air before a backdrop of two colours;
/// the camera looks at both.
void make_cloudy_view(landscape::Landscape& scene);

/// What make_cloudy_view()'s camera sees in a direction that does not meet the ground: Beer and
/// Lambert along the way through the box, and the backdrop's colour there.
double radiance_of_cloudy_view(const landscape::Landscape& scene, const glm::dvec3& direction);

}  // namespace wold::test
