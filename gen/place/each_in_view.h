#pragma once

#include <algorithm>

#include "core/ground_map.h"
#include "core/parallel.h"
#include "place/view.h"

namespace wold::place {

/// Every sample of a map of the terrain that may be in the picture, in parallel: visit(i, j, place
/// on the ground in metres).
template <class Map, class Visit>
void each_in_view(const Map& map, const Heightfield& terrain, const View& view,
                  const Visit& visit) {
  // What stands there may lean into the picture, and values count up to the next one.
  const double margin_m = std::max(2.0, 1.5 * map.step_m());
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec3 at_m = above_ground(terrain, map.place_m(i, j), 0.0);
      if (view.may_see(at_m, margin_m)) visit(i, j, at_m);
    }
  });
}

}  // namespace wold::place
