#pragma once

#include "core/ground_map.h"

namespace wold::terrain {

/// How a map of heights at half a cell's steps has come to them.
enum class Held {
  exactly,
  by_cubic_convolution,  ///< from values at the cells, whose means are kept (with_means_kept())
};

/// How rough the ground is, place by place, just below what cells of heights can hold.
struct Roughness {
  /// Standard deviation, metres, of the ground's waves that are one to two cells long: the first
  /// octave that the cells have lost.
  FactorMap deviation_m;
  /// By how much the deviation falls from the octave above to that one, as a power of 2: the local
  /// Hurst exponent.
  FactorMap hurst;
};

/// As the finest octaves that the cells hold continue; `heights_m` has two steps a cell.
///
/// Their power is that in the differences between a map and itself smoothed by 1 2 1 over one cell,
/// and over two more (filters "a trous"), as the mean over some cells around. Power in the plane
/// falls with frequency^-p, p = 2 hurst + 2; the two differences tell p, by two parts for the place
/// and by three for the whole map. Below, power falls faster, since hillslopes are smooth (Perron,
/// Kirchner and Dietrich 2008): by frequency^-(p + 1) in the first octave, the mean of windows of
/// three elevation models that were thinned.
Roughness measured_roughness(const GroundMap<double>& heights_m, Held held);

}  // namespace wold::terrain
