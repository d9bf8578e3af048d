#pragma once

#include <optional>

#include "scene/scene.h"
#include "terrain/water.h"

namespace wold::terrain {

/// The still_water() of terrain.elevation on the scene's square and as far around it as it is wide;
/// none where it has none. Of a model with more than 2048 cells along a side there, only every
/// second, third ... cell counts. `zero_m`: height of the scene's zero in the model. Throws
/// InputError.
std::optional<Lakes> model_lakes(const scene::Terrain& terrain, double zero_m);

}  // namespace wold::terrain
