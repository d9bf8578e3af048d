#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold::place {

/// What a viewpoint is looked for with.
struct ViewSearch {
  double eye_height_m;       ///< above the ground
  double field_of_view_deg;  ///< horizontal, below 180
  double height_over_width;  ///< of the picture
  glm::dvec3 to_sun;         ///< unit vector
};

/// A camera over a terrain.
struct Viewpoint {
  glm::dvec2 eye_m;
  glm::dvec2 target_m;     ///< inside the terrain, too
  double target_height_m;  ///< above the ground there, at least 0
};

/// A place on a wide terrain, and a direction, from which it makes a picture: the ground at the
/// feet, near, middle and far land and the sky take much the same part of it (the entropy of these
/// parts is the largest), mountains rise and fall along the skyline, the terrain goes on for long,
/// and the sun stands to the side. It is one of a regular lattice of places in the inner part of
/// the terrain, on gentle ground where there is some. A terrain without relief has such a place,
/// too.
Viewpoint find_viewpoint(const Heightfield& terrain, const ViewSearch& search);

}  // namespace wold::place
