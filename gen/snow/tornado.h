#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "scene/parts.h"
#include "snow/simd_lanes.h"

namespace wold::snow {

/// Wisps are drawn out along their way for at least so long.
inline constexpr double whirl_shutter_s = 0.04;

/// A funnel of whirling snow ([He2007], figure 7) over the terrain's middle, about which it
/// wanders; as high as 0.6 of the terrain is wide, from 10 to 120 m. Its radius grows exponentially
/// with height, twelvefold.
///
/// Flakes rise evenly and keep their fraction of the radius, so they move on helices that widen.
/// They circle as in Burgers and Rott's vortex, v = 1.398 v_core (r_c / r) (1 - exp(-1.256 (r /
/// r_c)^2)), fastest at its core's radius r_c. Both make the angle a closed form: rising at w, at
/// the height s H it has grown by the integral of v / r, proportional to (1 - exp(-k s)). What
/// leaves at the top is replaced at the foot by another. A fifth of the flakes whirls about the
/// foot.
class Tornado {
 public:
  /// `flakes` show it; each stands for a wisp of real ones, together they hide what is behind.
  Tornado(const scene::PrecipitationPart& part, std::uint64_t key, std::uint64_t flakes);

  std::uint64_t flakes() const { return flakes_; }
  /// Flake i of flakes(), above a ground of that height.
  Flake flake(std::uint64_t i, double time_s, double ground_m) const;
  /// The middle of its foot.
  glm::dvec2 foot_m(double time_s) const;

 private:
  struct Whirl {
    double radius_m;
    double height_m;
    double angle;
    glm::dvec3 velocity_m_s;  ///< outwards, ahead, up
  };
  Whirl rising(std::uint64_t i, double time_s) const;
  Whirl about_the_foot(std::uint64_t i, double time_s) const;
  double draw(std::uint64_t i, std::uint64_t purpose) const;

  std::uint64_t key_;
  std::uint64_t flakes_;
  glm::dvec2 middle_m_;
  double wander_m_;
  double height_m_;
  double foot_radius_m_;
  double speed_m_s_;  ///< v_core
  double flake_m_;    ///< diameter
};

}  // namespace wold::snow
