#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace wold::grass {

/// A blade of grass as it grows: a cone that stands on the patch and leans, and what sets it apart
/// from its neighbours when it withers. Metres, radians.
struct Blade {
  glm::vec2 root_m;   ///< on the patch, [0, patch)^2
  glm::vec2 heading;  ///< unit, the horizontal direction it leans and droops to
  float lean = 0.0F;  ///< angle of the axis from the vertical at the root
  float length_m = 0.0F;
  float radius_m = 0.0F;     ///< of the cone at the root; 0 at the tip
  float fresh_droop = 0.0F;  ///< droop coefficient of the living blade, rad / sqrt(m)
  float droop_rate = 0.0F;   ///< omega: droop gained per unit of lost support, rad / sqrt(m)
  float head_start = 0.0F;   ///< its own weathering degree while the meadow is fresh
  float onset = 0.0F;        ///< how far it is ahead (+) or behind (-) in weathering degree
  float brightness = 1.0F;   ///< factor on its albedo
};

/// Samples that are mingled into a patch (paper 1 section 4.1); 1 without mingling.
int sample_count(const scene::Grass& grass);

/// The blades of one sample of one variant of the patch. grass.blades are shared out as evenly as
/// possible, the first samples get one more. Roots are stratified within the sample, one per cell
/// of a grid, so that no bald spot repeats over the hillside; everything is keyed by (seed, sample,
/// variant, blade number).
std::vector<Blade> scatter_blades(const scene::Grass& grass, const scene::Ageing& ageing,
                                  std::uint64_t seed, int variant, int sample = 0);

/// The blade that has the mean of everything: no spread, no head start. It grows at the corner and
/// leans to the east.
Blade mean_blade(const scene::Grass& grass, const scene::Ageing& ageing);

/// How far a blade has withered.
struct BladePose {
  float droop = 0.0F;            ///< c, rad / sqrt(m)
  float length_scale = 1.0F;     ///< of arc lengths
  float vein_width = 1.0F;       ///< of distances from the axis, vein tissue
  float mesophyll_width = 1.0F;  ///< the same, mesophyll tissue
};

/// A point of a blade's axis: place relative to the root and the unit tangent, both within the
/// vertical plane of the blade: (along heading, up).
struct AxisPoint {
  glm::vec2 position_m;
  glm::vec2 tangent;
};

/// Where the axis is at arc length `arc_m` from the root (0 to length * length_scale).
///
/// Paper 1 section 3.1 lets a point at distance l turn about the root with omega_i = omega
/// h_i^(1/2), so that after some time a point at radius r stands at the polar angle lean + c
/// sqrt(r). Turning the points of a straight blade rigidly would stretch it; here the polar curve
/// is kept and run through by arc length, for which it has a closed form:
///   s = 8 / (3 c^2) ((1 + c^2 r / 4)^(3/2) - 1).
/// Speeds at c = 0 are the paper's, length is kept exactly, and the result does not depend on the
/// number of time steps. What would sink below the ground lies on it.
AxisPoint axis_point(const Blade& blade, const BladePose& pose, float arc_m);

}  // namespace wold::grass
