#pragma once

#include "grass/mechanics/vein_forces.h"

namespace wold::grass {

/// Moves the points of a vein on by `seconds` under their weight and a load: the step of Algorithm
/// 1 from [x, v] to [x', v'] by f / m.
///
/// Implicit Euler: forces are those at the end of the step, so that no stiffness makes it unstable
/// and a step that is long beside the blade's swing ends in its equilibrium. In the angles of the
/// segments, so that lengths stay. The end minimises
///   sum m |x - x0 - v0 h|^2 / (2 h^2) + bending + height + damping
/// (Martin et al. 2011, ACM Transactions on Graphics 30:72), found by Newton's method.
void step_vein(VeinPoints& points, const VeinLoad& load, double seconds);

/// Steps of 10 s until nothing moves any more.
void settle_vein(VeinPoints& points, const VeinLoad& load);

}  // namespace wold::grass
