#include "terrain/ledges.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "terrain/rock.h"

namespace wold::terrain {

namespace {

/// Slabs of snow break off on slopes of up to 50 degrees, and on those beyond 60 little lies: where
/// between them is a choice.
constexpr double steepest_deg = 56.0;

}  // namespace

FactorMap ledges(const Surface& surface, const scene::Terrain& look, std::uint64_t seed) {
  constexpr double strip_deg = 5.0, deg_per_exposure = 4.0;
  const GroundGrid& grid = surface.grid();
  const Rock rock(glm::vec3(1.0F), seed, grid.step_m());
  FactorMap map(grid.samples, grid.square, 1.0F);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(surface.part(j), [&](int i) {
      const double share = glm::smoothstep(look.rock_slope_deg - strip_deg, look.rock_slope_deg,
                                           surface.slope_deg(i, j));
      if (share <= 0.0) return;
      const glm::dvec3 place_m(map.place_m(i, j), surface.height_m(i, j));
      const double held = rock.ledges(
          place_m, surface.up(i, j),
          steepest_deg - deg_per_exposure * std::clamp(surface.exposure(i, j), -2.0, 2.0));
      map.at(i, j) = static_cast<float>(std::lerp(1.0, held, share));
    });
  });
  return map;
}

}  // namespace wold::terrain
