#pragma once

#include <glm/glm.hpp>

#include "cloud/clouds.h"
#include "core/ground_map.h"

namespace wold::cloud {

/// Fraction of the sun's light that comes straight through all layers to the ground, in [0, 1], by
/// world x and y: exp(-depth / cosine) of every layer where the ray to the sun meets its base,
/// which it does at an angle of that cosine to the vertical there (layer_crossing.h). It multiplies
/// the sun's part of a light map; `samples` along each side of the terrain, or on a grid.
/// sun_direction: unit vector to the sun; from below the horizon it shines as from there.
FactorMap sunlit_fraction(const CloudState& state, const Heightfield& terrain,
                          const glm::dvec3& sun_direction, int samples);
FactorMap sunlit_fraction(const CloudState& state, const Heightfield& terrain,
                          const glm::dvec3& sun_direction, const GroundGrid& grid);

}  // namespace wold::cloud
