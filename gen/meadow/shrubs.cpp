#include "meadow/shrubs.h"

#include <cmath>

#include "core/elementary.h"
#include "meadow/cell_uniform.h"

namespace wold::meadow {

ShrubPlace shrub_place(const scene::Scene& scene, const place::CellWindow& window,
                       const glm::ivec2& cell) {
  const auto drawn = [&](const char* purpose) { return cell_uniform(scene.seed, cell, purpose); };
  ShrubPlace place;
  place.size = smallest_shrub * math::pow(largest_shrub / smallest_shrub, drawn("shrub size"));
  const glm::dvec2 from_corner(cell - window.first);
  const double reach = 0.5 * place.size;  // of its patch, in cells
  const double last = window.per_side - reach;
  const double east = drawn("shrub east"), north = drawn("shrub north");
  const glm::dvec2 middle = glm::clamp(from_corner + glm::dvec2(east, north), std::min(reach, last),
                                       std::max(reach, last));
  place.shift_m = scene.grass.patch_m * (middle - from_corner - 0.5);
  return place;
}

}  // namespace wold::meadow
