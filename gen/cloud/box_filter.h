#pragma once

#include <vector>

#include "cloud/periodic_map.h"

namespace wold::cloud {

/// Means over squares of 2 radius + 1 pixels about every pixel, radius >= 0; the map continues at
/// its other side. Twice gives a smooth kernel.
PeriodicMap<float> box_filtered(const PeriodicMap<float>& map, int radius);

/// The map, and after it maps that have half as many pixels a side as the one before, means of 2 x
/// 2 of its, as long as sides are even and longer than a few pixels.
std::vector<PeriodicMap<float>> with_halves(PeriodicMap<float> map);

/// What tops of heaps follow, a map of depths or ranks smoothed over a sixth of the layer's
/// thickness: single columns would stand out of a cloud like needles. thickness_px >= 0: in pixels
/// of the map.
PeriodicMap<float> smoothed_for_tops(const PeriodicMap<float>& map, double thickness_px);

/// Radius in pixels of each of the two box filters that do so, at most what fits into a map that is
/// `side_px` wide.
int tops_radius_px(double thickness_px, int side_px);

}  // namespace wold::cloud
