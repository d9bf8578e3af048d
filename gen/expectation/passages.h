#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

#include "core/parallel.h"
#include "expectation/cell_finder.h"
#include "expectation/sights.h"
#include "landscape/landscape.h"

namespace wold::expectation {

/// A piece of a line of sight on its way down to the ground, above one cell.
struct Passage {
  int cell = 0;                       ///< its number
  double begin_m = 0.0, end_m = 0.0;  ///< from the eye
};

/// A place on a line of sight.
inline glm::dvec3 place_m(const landscape::Landscape& landscape, const Sight& sight,
                          double distance_m) {
  return landscape.camera.eye_m + distance_m * sight.direction;
}

/// From the nearest to the farthest. `canopy_m`: nothing stands higher above its cell.
template <class Instance>
std::vector<Passage> passages(const landscape::Landscape& landscape,
                              const CellFinder<Instance>& finder, double canopy_m,
                              const Sight& sight) {
  constexpr int most = 256;
  constexpr double growth = 1.02;  // of pieces: the higher above the ground, the longer
  constexpr double shortest_m = 1e-6;
  double piece_m =
      std::min(0.25 * landscape.patch_m / std::max(glm::length(glm::dvec2(sight.direction)), 1e-9),
               canopy_m / std::max(std::abs(sight.direction.z), 1e-9));
  std::vector<Passage> found;
  double end_m = sight.bare.distance_m;
  for (int i = 0; i < most && end_m > shortest_m; ++i) {
    const double begin_m = std::max(0.0, end_m - piece_m);
    const glm::dvec2 middle_m(place_m(landscape, sight, 0.5 * (begin_m + end_m)));
    finder.each_at(middle_m, [&](int cell) { found.push_back({cell, begin_m, end_m}); });
    const glm::dvec3 at_m = place_m(landscape, sight, begin_m);
    if (at_m.z - double{landscape.terrain.sample(at_m.x, at_m.y)} > canopy_m) break;
    end_m = begin_m;
    piece_m *= growth;
  }
  std::ranges::reverse(found);
  return found;
}

/// The passages of each line of sight, from the nearest to the farthest.
using Ways = std::vector<std::vector<Passage>>;

/// Those of lines of sight that meet the ground.
template <class Instance>
Ways ways_through(const landscape::Landscape& landscape, const std::vector<Instance>& cells,
                  double canopy_m, const std::vector<Sight>& sights) {
  Ways ways(sights.size());
  if (cells.empty()) return ways;
  const CellFinder finder(cells, landscape.patch_m);
  parallel_for(sights.size(), [&](std::size_t i) {
    if (sights[i].meets_ground) ways[i] = passages(landscape, finder, canopy_m, sights[i]);
  });
  return ways;
}

/// The numbers of those that are met, rising.
template <class Instance>
std::vector<int> cells_met(const std::vector<Instance>& cells, const Ways& ways) {
  std::vector<bool> met(cells.size(), false);
  for (const std::vector<Passage>& way : ways)
    for (const Passage& passage : way) met[static_cast<std::size_t>(passage.cell)] = true;
  std::vector<int> numbers;
  for (std::size_t i = 0; i < met.size(); ++i)
    if (met[i]) numbers.push_back(static_cast<int>(i));
  return numbers;
}

}  // namespace wold::expectation
