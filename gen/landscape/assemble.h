#pragma once

#include <functional>
#include <span>

#include "landscape/cells.h"
#include "landscape/landscape.h"
#include "light/daylight.h"
#include "scene/scene.h"

namespace wold::landscape {

/// Gives the baked volume of a choice; only its variant, key_frame, turn and level count.
using VolumeLookup = std::function<Volume(const CellChoice&)>;

/// One frame (from 1) as the exporters want it: `choices` are choose_cells', `lookup` is called
/// once for each different (variant, key_frame, turn, level), in ascending order, and what it gives
/// are the landscape's volumes in that order.
///
/// exposure_gain is 1.6 pi 2^exposure: under the daylight's unit, a white Lambertian sheet that
/// lies in the open comes out as 1.6; meadow and sky then have a camera's brightness.
Landscape assemble(const scene::Scene& scene, const Heightfield& terrain,
                   const light::Daylight& day, int frame, std::span<const CellChoice> choices,
                   const VolumeLookup& lookup);

/// Share of the daylight that reaches the ground between the blades, (0, 1]: Beer and Lambert with
/// the leaf area of the scene's tapering blades and Ross' G = 0.5, along a path 60 degrees off the
/// vertical, the mean of a cosine-weighted hemisphere's secants (2).
double canopy_transmittance(const scene::Grass& grass);

}  // namespace wold::landscape
