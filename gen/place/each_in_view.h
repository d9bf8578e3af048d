#pragma once

#include <algorithm>
#include <span>

#include "core/ground_map.h"
#include "core/parallel.h"
#include "core/row_parts.h"
#include "place/view.h"

namespace wold::place {

/// How far outside the picture samples count: what stands there may lean into it, and values count
/// up to the next one.
inline double margin_in_view_m(const View& view, double step_m) {
  return std::max(view.reach_m(), 2.0 * step_m);
}

/// Every sample of a map of the terrain that may be in the picture, in parallel: visit(i, j, place
/// on the ground in metres).
template <class Map, class Visit>
void each_in_view(const Map& map, const Heightfield& terrain, const View& view,
                  const Visit& visit) {
  const double margin_m = margin_in_view_m(view, map.step_m());
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec3 at_m = above_ground(terrain, map.place_m(i, j), 0.0);
      if (view.may_see_ground(at_m, margin_m)) visit(i, j, at_m);
    }
  });
}

/// One part for each row of a grid on the terrain: all of its places that a view's picture shows or
/// that lie less than `margin_m` from those.
inline RowParts rows_in_view(const GroundGrid& grid, const Heightfield& terrain,
                             std::span<const View> views, double margin_m) {
  RowParts parts(static_cast<std::size_t>(grid.samples));
  parallel_for(parts.size(), [&](std::size_t row) {
    for (int i = 0; i < grid.samples; ++i) {
      const glm::dvec2 at_m =
          grid.square.corner_m + glm::dvec2(i, static_cast<double>(row)) * grid.step_m();
      const glm::dvec3 ground_m = above_ground(terrain, at_m, 0.0);
      const auto shows = [&](const View& view) { return view.may_see_ground(ground_m, margin_m); };
      if (std::ranges::any_of(views, shows)) add_sample(i, parts[row]);
    }
  });
  return parts;
}
inline RowParts rows_in_view(const GroundGrid& grid, const Heightfield& terrain, const View& view,
                             double margin_m) {
  return rows_in_view(grid, terrain, std::span(&view, 1), margin_m);
}

}  // namespace wold::place
