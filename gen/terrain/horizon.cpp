#include "terrain/horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"

namespace wold::terrain {

double horizon_rad(const Heightfield& terrain, const glm::dvec2& from_m,
                   const glm::dvec2& direction, double spacing) {
  const double height_m = terrain.sample(from_m.x, from_m.y);
  double highest = -std::numeric_limits<double>::infinity();
  for (double distance_m = terrain.step_m();;
       distance_m += std::max(terrain.step_m(), distance_m * spacing)) {
    const glm::dvec2 at_m = from_m + direction * distance_m;
    if (std::min(at_m.x, at_m.y) < 0.0 || std::max(at_m.x, at_m.y) > terrain.size_m()) break;
    highest = std::max(highest, (terrain.sample(at_m.x, at_m.y) - height_m) / distance_m);
  }
  return math::atan(highest);
}

bool is_hidden(const Heightfield& terrain, const glm::dvec3& from_m, const glm::dvec3& to_m) {
  const glm::dvec3 way_m = to_m - from_m;
  const double steps = std::ceil(glm::length(glm::dvec2(way_m)) / terrain.step_m());
  for (long step = 1; step < steps; ++step) {
    const glm::dvec3 at_m = from_m + way_m * (static_cast<double>(step) / steps);
    if (double{terrain.sample(at_m.x, at_m.y)} > at_m.z) return true;
  }
  return false;
}

}  // namespace wold::terrain
