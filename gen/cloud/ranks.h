#pragma once

#include <vector>

#include "cloud/periodic_map.h"

namespace wold::cloud {

/// A field's value turned into its rank: the fraction, in (0, 1), of the pixels of all `fields`
/// together that are lower. Ranks are spread evenly, so the highest share c of a sky has ranks
/// above 1 - c. Equal values, such as clear sky in a picture, are told apart by how cloudy their
/// surroundings are, and then by their places.
std::vector<PeriodicMap<float>> ranked(const std::vector<PeriodicMap<float>>& fields);

}  // namespace wold::cloud
