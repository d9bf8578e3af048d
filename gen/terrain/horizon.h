#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"

namespace wold::terrain {

/// The terrain's own horizons in some directions, seen from places on the ground.
class Horizons {
 public:
  /// directions: unit vectors in the plane. Ground points are looked at every grid step, farther
  /// out every `spacing` (> 0) times the distance; what is narrower than that can be missed. The
  /// terrain has to outlive this.
  Horizons(const Heightfield& terrain, std::vector<glm::dvec2> directions, double spacing);

  std::size_t directions() const { return directions_.size(); }

  /// Elevation angle (radians) of the horizon in a direction, from a place on the ground (metres):
  /// the largest angle to the ground points on the way to the map's border, and that of the slope
  /// `lowest` at least. The steeper that is, the sooner the answer is known.
  double elevation_rad(std::size_t direction, const glm::dvec2& from_m, double lowest) const;

 private:
  const Heightfield* terrain_;
  std::vector<glm::dvec2> directions_;
  double spacing_;
  /// For each direction, for each block of the terrain: no ground is higher from there on.
  std::vector<std::vector<float>> ahead_m_;
};

/// Whether the ground rises above the straight line between two points, looked at every grid step.
bool is_hidden(const Heightfield& terrain, const glm::dvec3& from_m, const glm::dvec3& to_m);

}  // namespace wold::terrain
