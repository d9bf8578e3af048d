#pragma once

#include <vector>

#include "scene/consistency.h"

namespace wold::scene {

/// Adds a problem for a season that contradicts itself: days that are none, do not follow each
/// other or on which the sun does not rise high enough at sun.time, a season without anything that
/// withers its grass, [[season_keys]] without a season.
void report_season_contradictions(const Scene& scene, const Places& places,
                                  std::vector<Problem>& problems);

}  // namespace wold::scene
