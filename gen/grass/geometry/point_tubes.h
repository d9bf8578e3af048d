#pragma once

#include <span>

#include "core/tubes.h"
#include "grass/mechanics/dynamics.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// The point-based structure of a patch ([TVT], figure 7) as something a renderer can draw: an
/// octahedron per point, along its tangent, that shows on average the area the point stands for,
/// with the point's own material; those of the snow are among them, `snow_step_m` as in
/// snow_points(). `patch` holds the same blades as `samples`, one sample after the other; they
/// throw the shadows, as in blade_tubes().
Tubes point_tubes(const BladePatch& patch, std::span<const PointDynamics> samples,
                  const Lighting& lighting, const FibreLook& look, double snow_step_m);

}  // namespace wold::grass
