#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "landscape/landscape.h"

namespace wold::test {

/// Makes a landscape one of an even ground without end, three flakes in a row of different pictures
/// and opacities and a fourth alone, in fog; the camera looks north over the ground.
void make_snowy_view(landscape::Landscape& scene);

/// Directions of make_snowy_view()'s camera in which there are the ground, the sky, the first, the
/// first two and all three flakes of the row before the ground, and the fourth before the sky. None
/// is near an edge.
std::vector<glm::dvec3> directions_of_snowy_view();

/// What the camera sees in such a direction: from the ground or the endless sky on, each stretch of
/// fog and each flake in turn lets part of the light through and adds its own. Channel of green.
double radiance_of_snowy_view(const landscape::Landscape& scene, const glm::dvec3& direction);

/// Adds `count` keyed flakes of three pictures before the camera, 0.3 to `reach_m` away, as wide as
/// 6 mm and turned any way, some drawn out by their fall and fainter; and no fog.
void add_flakes(landscape::Landscape& scene, int count, double reach_m);

}  // namespace wold::test
