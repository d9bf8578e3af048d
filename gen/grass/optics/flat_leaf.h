#pragma once

#include <glm/glm.hpp>

#include "grass/optics/shading.h"

namespace wold::grass {

/// Irradiance of one side of a plane by diffuse light, for the unit normal of that side: the cosine
/// as a polynomial of second degree in it, 1/4 + c/2 + 5/16 P2(c), which is 5 % off at most for
/// light that comes from a half of all directions or more.
glm::vec3 irradiance_of_side(const DiffuseLight& light, const glm::vec3& normal);

/// The area that a flat leaf shows to a direction, over its mean over all directions: 2 |n d|. The
/// mean over all turns about the leaf's axis is kajiya_kay_diffuse().
float flat_leaf_area(const glm::vec3& normal, const glm::vec3& direction);

/// Radiance that a leaf sends to the eye whose broad side is known, where source_radiance() takes
/// the mean over all turns about its axis: its two sides are Lambert's.
///
/// `normal`: unit, of either side, square to the fibre's tangent; the rest as source_radiance() has
/// it. The veins along a blade spread its highlight across it ([Comar2014]): about the axis it goes
/// with the cosine from the normal to the half-way direction, over the mean of that.
glm::vec3 flat_leaf_radiance(const Fibre& fibre, const glm::vec3& normal, const TurnedLight& light,
                             float sunlit, const DiffuseLight& diffuse, float specular_exponent);

}  // namespace wold::grass
