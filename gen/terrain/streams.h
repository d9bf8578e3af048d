#pragma once

#include <vector>

#include "core/ground_map.h"

namespace wold::terrain {

/// What streams do to the ground in a length of time, the stream-power law with n = 1, m = 0.5
/// (Howard 1994): dz/dt = U - K sqrt(A) S, where A is the area that drains through a point and S
/// the slope down to the steepest of the eight neighbours. It is linear in the heights and knows
/// areas as fractions of the map and lengths as fractions of its side only.
struct Incision {
  /// K t times the side: how many sides a notch travels upstream in the whole time where the whole
  /// map drains; sqrt(share) of that where a fraction of it does. 1 cuts gorges into the lower
  /// slopes, 10 reaches the crests; against uplift, 30 is near the steady state S = U / (K
  /// sqrt(A)).
  double reach = 1.0;
  /// Where a smaller fraction of the map than this drains, the ground is slope rather than channel
  /// and wears as if this fraction drained there: what slopes do must not depend on the samples'
  /// number.
  double source_fraction = 2e-4;
  int steps = 20;  ///< that the time is cut into; implicit ones, stable at any length
};

/// Lets streams cut valleys into the ground. Implicit steps from the mouths upstream (Braun and
/// Willett 2013); pits are filled to their lowest outlet (priority-flood, Barnes, Lehman and Mulla
/// 2014) and stay filled: afterwards every inner sample has a lower neighbour on its way to the
/// border. The map's border is the base level and keeps its heights.
/// The same for any number of threads.
void carve(GroundMap<double>& heights_m, const Incision& incision);

/// The same while the ground rises by `uplift_m` in the whole time (as many samples; what it says
/// at the border does not matter).
void carve(GroundMap<double>& heights_m, const GroundMap<double>& uplift_m,
           const Incision& incision);

/// By the place in GroundMap::values(): whether a sample keeps its height and takes all the water
/// that comes to it.
using BaseLevel = std::vector<bool>;

/// The same down to a base level of its own, of as many samples as the map, instead of the border.
/// Where samples of the border are none of it, water flows on over the opposite side: the map is a
/// tile whose sides join, each a step from the other. Throws std::invalid_argument where no sample
/// is base level.
void carve(GroundMap<double>& heights_m, const GroundMap<double>& uplift_m,
           const BaseLevel& base_level, const Incision& incision);

/// How many samples drain through each, itself included: down the steepest of the eight neighbours,
/// out of pits over their lowest outlets. The map's border is where water leaves.
GroundMap<double> drained_samples(const GroundMap<double>& heights_m);

}  // namespace wold::terrain
