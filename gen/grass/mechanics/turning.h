#pragma once

#include "grass/mechanics/vein.h"

namespace wold::grass {

/// One step of [TVT]'s law of falling (section 3.1): every point turns about the root with
/// v = omega l, omega its droop per time times h^(1/2), h and l its distance from the root; `droop`
/// is what the droop coefficient grows by, rad / sqrt(m), `seconds` the time it takes.
///
/// Points further out turn faster, which stretches the blade; then the blade draws itself together
/// along itself, from the root on, until every segment is as long as `length_m` asks. What would
/// sink below the ground lies on it. In the limit of small steps this is PaperAxis.
void turn_vein(VeinPoints& points, double length_m, double droop, double seconds);

}  // namespace wold::grass
