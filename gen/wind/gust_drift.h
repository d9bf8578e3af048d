#pragma once

#include <glm/glm.hpp>

#include "wind/gusts.h"
#include "wind/moment.h"

namespace wold::wind {

/// Where gusts have taken what floats about a place, besides the mean wind, and how fast they do:
/// metres and m/s east, north and up.
struct GustDrift {
  glm::dvec3 way_m{0.0};
  glm::dvec3 velocity_m_s{0.0};
};

/// Of the gusts that are longer than `shortest_m` along the wind, at a place on the ground and a
/// height above it, metres; a closed form. While the wind keeps its direction the way is the
/// integral of the velocity over time.
GustDrift gust_drift(const Gusts& gusts, const glm::dvec2& place_m, double height_m,
                     double shortest_m, const Moment& now);

}  // namespace wold::wind
