#pragma once

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/surface.h"

namespace wold::place {

/// Where grass grows on the scene's ground: 1 where it stands, 0 where none does, in between along
/// ragged borders. A sample every 5 cm (4097 a side at most).
///
/// Slope, height and the mask say with which probability it grows at a place, growth.cover at most,
/// and less where no species of the meadow has its habitat (Habitats::any()); keyed noise of
/// growth.feature, equalised to be uniform, decides. On large terrains it is less on slopes that
/// face the noon sun, unless a mask, terrain.cover or terrain.photo says what grows. None grows in
/// water, on scree and where feet have worn the ground, and where terrain.cover or terrain.photo
/// says so less. So the mean of the map is the mean probability. Throws FileError when a mask
/// cannot be read.
FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain,
                     const terrain::KnownGround& known = {});
/// The same on a surface's grid; where patches are smaller than its step it shows the probability.
/// None at places that do not count.
FactorMap growth_map(const scene::Scene& scene, const terrain::Surface& surface);

}  // namespace wold::place
