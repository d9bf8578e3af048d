#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace wold::place {

/// Where and when the wind is asked for.
struct WindPoint {
  glm::dvec2 place_m;     ///< on the terrain, east and north
  double height_m = 0.0;  ///< above the ground
  double time_s = 0.0;    ///< since the film's first frame
};

/// East, north and up, m/s, at each point: air_flow()'s under the weather of the scene's film.
/// Throws what terrain::make_ground(), phenology::film_season() and snow::Weather throw.
std::vector<glm::dvec3> wind_at(const scene::Scene& scene, std::span<const WindPoint> points);

}  // namespace wold::place
