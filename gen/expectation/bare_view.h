#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "landscape/landscape.h"

namespace wold::expectation {

/// What is seen along a ray, and how far away it is.
struct Hit {
  glm::vec3 radiance{0.0F};
  double distance_m = std::numeric_limits<double>::infinity();
};

/// The ground and what is behind everything, along a unit direction from the eye, without what
/// stands or floats before it. The ground is `ground_m` away, as GroundMarch says; where that is
/// infinite the backdrop is seen, or the sky.
Hit bare_view(const landscape::Landscape& landscape, const glm::dvec3& eye_m,
              const glm::dvec3& direction, double ground_m);

}  // namespace wold::expectation
