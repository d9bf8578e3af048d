#pragma once

#include <array>
#include <glm/glm.hpp>

#include "grass/mechanics/meadow_model.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// The gaps between blades that sunlight and sight have in common on their ways to the ground.
///
/// Where the eye looks down the sun's rays both pass the same gaps, and all ground that is seen is
/// sunlit: the hot spot. Blades stand at random, and gaps are as wide as blades [Kuusk1985]: with
/// optical depths d_s and d_o along both ways the ground is reached and seen with the probability
/// exp(-d_s - d_o + sqrt(d_s d_o) (1 - exp(-a)) / a), where a grows as sun and sight part.
class SharedGaps {
 public:
  /// `patch` tiles and has blades.
  SharedGaps(const BladePatch& patch, const MeadowModel& model);

  /// Fraction of the ground that a direction reaches where the share `growth`, in [0, 1], of the
  /// blades grows.
  double passing(const glm::dvec3& direction, double growth = 1.0) const;

  /// How much more of the ground that is seen is sunlit than of all ground, as a fraction of the
  /// ground. Directions are unit, towards sun and eye; one below the horizon counts as level.
  double more_sunlit(const glm::dvec3& sun, const glm::dvec3& eye, double growth = 1.0) const;

 private:
  double depth(const glm::dvec3& direction) const;

  static constexpr int steps = 18;
  /// Area of the blades that is projected along a direction, over the ground's; mean over azimuths,
  /// by the angle off the vertical, evenly from 0 to 90 degrees.
  std::array<double, steps + 1> projected_{};
  double leaf_area_index_ = 0.0;  ///< one-sided
  double hot_spot_ = 0.0;         ///< size of the blades over the height of what they fill evenly
};

}  // namespace wold::grass
