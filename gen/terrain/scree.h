#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "core/noise.h"

namespace wold::terrain {

/// Debris of rock faces, which lies below them as talus slopes and as fans at the foot of gullies.
///
/// What breaks off a face runs down to all lower neighbours, more of it to the steeper ones
/// [Freeman1991], and as far as an energy line of 27.5 degrees from the face lies above the ground
/// (the smallest shadow angle of talus, [Evans1993]). It does not stay where it is steeper
/// than its angle of repose, up to 38 degrees.
class Scree {
 public:
  /// `rock_slope_deg`: rock shows where the ground is steeper.
  Scree(const Heightfield& heights_m, double rock_slope_deg, std::uint64_t seed);

  /// Share of ground that debris would cover if it were not too steep, in [0, 1].
  const FactorMap& likely() const { return likely_; }

  /// The look of it on maps with some step: tongues and patches of all sizes.
  class Patches {
   public:
    /// The scree has to outlive it. `step_m` > 0.
    Patches(const Scree& scree, double step_m);

    /// Share of a piece of ground, a step wide, that debris covers, in [0, 1]: on the mean over
    /// ground that is not too steep as likely(). `exposure`: Surface::exposure(); gullies have more
    /// of it than spurs.
    double share(const glm::dvec2& at_m, double slope_deg, double exposure) const;

   private:
    const Scree& scree_;
    ScaleFreeNoise field_;
    double softness_;
  };

 private:
  std::uint64_t key_;
  FactorMap likely_;
};

}  // namespace wold::terrain
