#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold::place {

/// The terrain with few enough samples that its surroundings are soon found: 129 along a side at
/// most.
Heightfield coarsened(const Heightfield& terrain);

/// How deep places lie below the mean of their surroundings, an eighth of the terrain wide, in
/// metres; negative where they rise above it. This is the topographic position of [Weiss2001] with
/// its sign turned. For a coarsened() terrain.
FactorMap depth_below_surroundings_m(const Heightfield& terrain);

/// The same in hollows alone, over that of the deepest: 1 there, 0 outside them.
FactorMap hollows(const Heightfield& terrain);

/// Noon's sun at the equinox: unit vector to it.
glm::dvec3 equinox_sun(double latitude_deg);

/// Sunlight on a slope, by its gradient, over that on level ground; at most twice as much counts.
/// Near the poles level ground counts as if the sun were 12 degrees high: even slopes are not dry.
double sun_over_level(const glm::dvec2& gradient, const glm::dvec3& sun);

/// What plants may ask of places of a terrain.
class Topography {
 public:
  Topography(const Heightfield& terrain, double latitude_deg);

  /// The fraction of the terrain that is drier, in [0, 1]: that lies less deep below its
  /// surroundings. Places that are equally deep have the mean of their ranks, so that level ground
  /// has 1/2.
  double wetness(const glm::dvec2& at_m) const;

  /// sun_over_level() there, at noon of the equinox.
  double sun(const glm::dvec2& at_m) const;

 private:
  Heightfield terrain_;  ///< coarsened
  glm::dvec3 sun_;
  FactorMap wetness_;
};

}  // namespace wold::place
