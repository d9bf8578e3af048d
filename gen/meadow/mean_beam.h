#pragma once

#include "scene/scene.h"
#include "wind/beam.h"

namespace wold::meadow {

/// The scene's leaves in the mean of their species, by their shares, as a beam: at a weathering
/// degree, with the water and stiffness that they have there, and under the fraction `snow` of the
/// snow that they can carry.
wind::Beam mean_beam(const scene::Scene& scene, double weathering, double snow);

}  // namespace wold::meadow
