#pragma once

#include <vector>

#include "cloud/periodic_map.h"

namespace wold::cloud {

/// A field's value turned into its rank: the fraction, in (0, 1), of the pixels of all `fields`
/// together that are lower. Ranks are spread evenly, so the highest share c of a sky has ranks
/// above 1 - c. Equal values, such as clear sky in a picture, are told apart by how cloudy their
/// surroundings are, and then by their places.
std::vector<PeriodicMap<float>> ranked(const std::vector<PeriodicMap<float>>& fields);

/// Quantiles of a standard normal distribution and back (Gaussianisation, Heitz and Neyret 2018);
/// `rank` in (0, 1). Boost.Math's quantile would call the C library's exp() and log(), whose last
/// bits differ from system to system; these have core/elementary.h's.
double gaussian_of_rank(double rank);
double rank_of_gaussian(double gaussian);

}  // namespace wold::cloud
