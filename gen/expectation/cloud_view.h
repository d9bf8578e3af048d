#pragma once

#include <glm/glm.hpp>
#include <span>

#include "landscape/aggregate_appearance.h"
#include "landscape/landscape.h"

namespace wold::expectation {

/// What clouds that are volumes show along a ray.
struct SeenBox {
  landscape::AggregateAppearance look;
  double distance_m = 0.0;  ///< to the middle of what is seen of them; 0 where there are none
};

/// Along a unit direction from the eye, as far as `end_m`. Clouds from the highest to the lowest.
SeenBox cloud_view(std::span<const landscape::CloudBox> clouds, const glm::dvec3& eye_m,
                   const glm::dvec3& direction, double end_m);

}  // namespace wold::expectation
