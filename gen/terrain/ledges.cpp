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

FactorMap ledges(const Surface& surface, const FactorMap& growth, const scene::Terrain& look,
                 std::uint64_t seed) {
  constexpr double border_deg = 2.5, deg_per_exposure = 4.0;
  const GroundGrid& grid = surface.grid();
  const Rock rock(glm::vec3(1.0F), seed, grid.step_m());
  FactorMap map(grid.samples, grid.square, 1.0F);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(surface.part(j), [&](int i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      const double exposure = surface.exposure(i, j);
      const double share =
          (1.0 - growth.sample(at_m.x, at_m.y)) *
          glm::smoothstep(-border_deg, border_deg,
                          beyond_rock_deg(surface.slope_deg(i, j), exposure, look.rock_slope_deg));
      if (share <= 0.0) return;
      const double held =
          rock.ledges({at_m, surface.height_m(i, j)}, surface.up(i, j),
                      steepest_deg - deg_per_exposure * std::clamp(exposure, -2.0, 2.0));
      map.at(i, j) = static_cast<float>(std::lerp(1.0, held, share));
    });
  });
  return map;
}

}  // namespace wold::terrain
