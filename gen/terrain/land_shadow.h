#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "terrain/sun_disc.h"
#include "terrain/surroundings.h"

namespace wold::terrain {

/// The shadow that the land around a scene's square casts into it.
///
/// Along a sunray's plan the shadow's upper face falls as steeply as the ray. So the highest ray of
/// each plan, reckoned once, says how high the shadow stands everywhere on it: what is lower than
/// that of the disc's upper edge sees no sun, what is higher than that of its lower edge all of it.
class LandShadow {
 public:
  /// `to_sun`: unit vector. Land farther out than `reach_m` casts none.
  LandShadow(const Surroundings& land, const glm::dvec3& to_sun, double reach_m = 40000.0);

  /// Fraction of the sun's disc that is seen over the land around, in [0, 1]. World space, metres;
  /// the place is in the square.
  double sun_seen(const glm::dvec3& at_m) const;

 private:
  /// Heights of rays over the square's middle: z - r tan(elevation), r along the plan.
  struct Rays {
    double of_upper_edge, of_lower_edge;
  };
  /// Of one azimuth.
  struct Plans {
    glm::dvec2 towards;
    std::vector<Rays> rays;  ///< of plans side by side over the square
  };

  Rays highest(const Surroundings& land, const glm::dvec2& towards, double aside_m,
               double reach_m) const;
  double sun_seen(const glm::dvec3& at_m, const Plans& plans) const;
  /// Half of the square's width across a direction.
  double half_width_m(const glm::dvec2& towards) const;

  Square square_;
  double upper_edge_rise_ = 0.0, lower_edge_rise_ = 0.0;  ///< over level distance
  std::vector<Plans> plans_;  ///< of the disc's azimuths; none for a sun overhead
};

}  // namespace wold::terrain
