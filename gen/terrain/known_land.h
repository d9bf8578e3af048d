#pragma once

#include "core/ground_map.h"

namespace wold::terrain {

/// Land of which a part is known.
struct KnownLand {
  GroundMap<double> heights_m;   ///< where it is not known, smooth between what is
  GroundMap<double> distance_m;  ///< from what is known; 0 there
};

/// Fills in what is NaN in heights: nearly as a membrane hangs between what is known, from coarse
/// to fine (a pyramid as that of Gortler et al. 1996, The lumigraph, evened out). 0 everywhere
/// where nothing is known.
KnownLand filled_in(GroundMap<double> heights_m);

}  // namespace wold::terrain
