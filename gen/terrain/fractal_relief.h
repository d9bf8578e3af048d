#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::terrain {

/// Adds fBm of the scene's roughness and octaves, of this standard deviation; its largest features
/// are `feature_m` wide.
void add_fractal_relief(GroundMap<double>& heights_m, const scene::Terrain& terrain,
                        std::uint64_t seed, double deviation_m, double feature_m);

}  // namespace wold::terrain
