#pragma once

#include <glm/glm.hpp>
#include <numbers>
#include <variant>

#include "grass/geometry/blade.h"
#include "grass/mechanics/elastica.h"

namespace wold::grass {

/// Lean of the most upright elastic blades, rad: a leaf parts from its shoot, it does not stand on
/// it like a column that waits to buckle (modelling choice, 5 degrees).
inline constexpr float min_lean = 5.0F * std::numbers::pi_v<float> / 180.0F;

/// A point of a blade's axis: place relative to the root and the unit tangent, both within the
/// vertical plane of the blade: (along heading, up).
struct AxisPoint {
  glm::vec2 position_m;
  glm::vec2 tangent;
};

/// Something of a blade's plane, (along heading, up), as a direction of the patch.
inline glm::vec3 from_plane(const Blade& blade, const glm::vec2& in_plane) {
  return {blade.heading * in_plane.x, in_plane.y};
}

/// Where a point of the axis is on the patch, metres, not wrapped.
inline glm::vec3 on_patch_m(const Blade& blade, const AxisPoint& at) {
  return foot_m(blade) + from_plane(blade, at.position_m);
}

/// An axis by [TVT]'s rule ([TVT], section 3.1).
///
/// A point at distance l turns about the root with omega_i = omega h_i^(1/2), so that after some
/// time a point at radius r stands at the polar angle lean + c sqrt(r). Turning the points of a
/// straight blade rigidly would stretch it; here the polar curve is kept and run through by arc
/// length, for which it has a closed form:
///   s = 8 / (3 c^2) ((1 + c^2 r / 4)^(3/2) - 1).
/// Speeds at c = 0 are [TVT]'s, length is kept exactly, and the result does not depend on the
/// number of time steps. What would sink below the ground lies on it.
///
/// Against theory: to first order in the load B (elastica.h) a blade at `lean` sinks by
/// B L sin(lean) (u^2 / 4 - u^3 / 6 + u^4 / 24), u = s / L, [TVT]'s by c sqrt(L) L u^(3/2).
/// The tips agree for
///   c sqrt(L) = B sin(lean) / 8 / (1 - B cos(lean) / 7.8373)
/// (the second factor: what the weight along the blade adds, up to Greenhill's load), within 2 % as
/// long as the tip moves by less than 0.16 L. With c fitted to the tip, [TVT]'s blade
///   - is off by 2 % of the tip's way (too low next to the root, too high next to the tip), at
///     leans of 10 to 20 degrees by 3 % at B = 5 and by 3.5 % at B = 10;
///   - turns its tip by 9/8 of the elastica's angle;
///   - bends infinitely at the root, where the elastica bends by B sin(lean) / 2 per length.
/// So [TVT]'s shapes are sound; what departs is how much blades of different lengths droop: one
/// c for all turns the tip as sqrt(L), theory as L^3 for one section (as L where the section grows
/// with the blade), and right over beyond Greenhill's load.
class PaperAxis {
 public:
  /// `droop` is c in rad / sqrt(m), at least 0.
  PaperAxis(float lean, float droop) : lean_(lean), droop_(droop) {}
  AxisPoint at(float arc_m) const;

 private:
  float lean_;
  float droop_;
};

/// An axis that is a heavy elastica of this length. From where it would sink below the ground, the
/// rest lies on it; that the ground carries that rest is left out.
class ElasticaAxis {
 public:
  ElasticaAxis(float lean, float load, float length_m);
  AxisPoint at(float arc_m) const;

 private:
  Elastica nodes_;
  float length_m_;
  double touch_ = 2.0;        ///< where it meets the ground, along it; beyond 1: nowhere
  double touch_place_ = 0.0;  ///< that place along the heading, in lengths
};

/// An axis through the points of a vein. From where it would sink below the ground, the rest lies
/// on it.
class VeinAxis {
 public:
  VeinAxis(const VeinPlaces& places, float length_m);
  AxisPoint at(float arc_m) const;

 private:
  VeinPlaces places_m_;
  float length_m_;
};

/// The axis of a blade in a pose: its vein's where Algorithm 1 has moved it, else the closed form
/// of the pose's rule. Made once, then sampled.
class BladeAxis {
 public:
  BladeAxis(const Blade& blade, const BladePose& pose);
  /// Where the axis is at arc length `arc_m` from the root, 0 to length * length_scale.
  AxisPoint at(float arc_m) const;

 private:
  std::variant<PaperAxis, ElasticaAxis, VeinAxis> axis_;
};

}  // namespace wold::grass
