#include "meadow/shrubs.h"

#include <cmath>

#include "core/elementary.h"
#include "meadow/cell_uniform.h"

namespace wold::meadow {

ShrubPlace shrub_place(const scene::Scene& scene, const place::CellWindow& window,
                       const CellLattice& lattice, const glm::ivec2& cell) {
  const auto drawn = [&](const char* purpose) { return cell_uniform(scene.seed, cell, purpose); };
  ShrubPlace place;
  place.size = smallest_shrub * math::pow(largest_shrub / smallest_shrub, drawn("shrub size"));
  const double patch_m = scene.grass.patch_m;
  const double reach_m = 0.5 * place.size * patch_m;  // of its patch
  const double last_m = window.per_side * patch_m - reach_m;
  const double east = drawn("shrub east"), north = drawn("shrub north");
  const glm::dvec2 corner_m = glm::dvec2(window.first) * patch_m;
  const glm::dvec2 middle_m =
      corner_m + glm::clamp(lattice.ground(cell).place_m({east, north}) - corner_m,
                            std::min(reach_m, last_m), std::max(reach_m, last_m));
  place.shift_m = middle_m - (glm::dvec2(cell) + 0.5) * patch_m;
  return place;
}

}  // namespace wold::meadow
