#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "terrain/water.h"

namespace wold::terrain {

/// The way from one place of a terrain to another that people wear on foot: of those on a grid the
/// one that takes them the least time, there and back, by Tobler's hiking function [Tobler1993],
/// straightened where that takes no longer. Turns take time, too, a choice: so it climbs steep
/// slopes in a few bends. Round lakes.
///
/// East and north of points along it, metres, `from_m` first and `to_m` last. The grid has 160
/// steps at most along its longer side, and reaches a third of the distance beyond both places:
/// what is smaller than its steps, it does not go round. The same for any system.
std::vector<glm::dvec2> walked_way(const Heightfield& heights_m, const glm::dvec2& from_m,
                                   const glm::dvec2& to_m, const Water* water);

/// Seconds that a metre takes on foot on a slope, rise over run, on the mean of up and down.
double seconds_per_metre(double slope);

}  // namespace wold::terrain
