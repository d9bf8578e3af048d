#pragma once

#include <glm/glm.hpp>

#include "grass/geometry/axis.h"
#include "grass/geometry/blade.h"

namespace wold::grass {

/// Density that snow on blades is given, kg/m3: fresh (Hedstrom and Pomeroy 1998: 68 to 119).
inline constexpr double blade_snow_kg_m3 = 100.0;

/// What a leaf can carry at most, kg per m2 of leaf: 0.70. Hedstrom and Pomeroy (1998, Hydrological
/// Processes 12:1611) have 6.0 (0.27 + 46 / density) per leaf area of a conifer, whose needles and
/// twigs bridge the gaps between them; a blade stands alone and carries a ridge about as high as it
/// is wide, 7 mm: a sixth of that.
inline constexpr double leaf_snow_kg_m2 = 0.16 * 6.0 * (0.27 + 46.0 / blade_snow_kg_m3);

/// Diffuse coefficient md of fresh snow, linear sRGB: its visible albedo, 0.9 with a little less in
/// the red, times 1.1, because opaque lumps send light back to where it came from while fibres
/// scatter alike in all directions (a diffuse sphere at phase angles of 60 to 90 degrees: 1.6 to
/// 0.85 of the even).
inline constexpr glm::vec3 snow_albedo{0.97F, 0.985F, 1.0F};

/// Fraction of the snow that stays on a blade whose tangent has this horizontal part, the sine of
/// its angle from the vertical: none up to 10 degrees, all from 50 degrees on (modelling choice:
/// cold snow rests on slopes of up to 50 to 60 degrees, and clings).
float snow_held(float horizontal);

/// Thickness of the snow at a place of a level blade, as a fraction of the most: `fraction` of what
/// the canopy can carry lies in lumps. `rank`, uniform in [0, 1), says which places get it last.
/// The mean over all ranks is `fraction`; it never falls as `fraction` grows.
float lump_thickness(double fraction, float rank);

/// Snow on a place of a blade: a ridge of elliptic section along its upper side.
struct SnowRidge {
  glm::vec2 centre_m{0.0F};  ///< in the blade's plane, from the root: (along heading, up)
  float half_width_m = 0.0F;
  float half_height_m = 0.0F;  ///< 0: no snow

  /// Mean projected area per length: a quarter of the surface (Cauchy), its girth by Ramanujan.
  float area_m() const;
};

/// The ridge at `along` (0 root to 1 tip), where the axis is `at`.
///
/// A flower's disc is level, whatever its axis. Snow gathers in tufts of 6 cm that neighbouring
/// blades share, and in lumps along each blade. The section is what lies there over its density. It
/// covers the blade's whole width from half of the most on, a little beyond its edges, and is no
/// higher than one and a half times the blade's width.
SnowRidge snow_ridge(const Blade& blade, const BladePose& pose, float along, const AxisPoint& at);

/// The direction of a blade's plane that its upper side faces.
inline glm::vec2 upper_side(const glm::vec2& tangent) { return {-tangent.y, tangent.x}; }

}  // namespace wold::grass
