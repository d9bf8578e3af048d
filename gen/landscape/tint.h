#pragma once

#include <functional>
#include <span>

#include "core/ground_map.h"
#include "landscape/cells.h"
#include "scene/scene.h"

namespace wold::landscape {

/// The mean colour of grass (linear RGB) at a weathering degree in [0, 1].
using GrassColour = std::function<glm::vec3(double)>;

/// A factor for Landscape::light that takes the squares out of a withering meadow: cells show one
/// key frame each, while the ground wants local_weathering. Inside a cell the factor is
/// colour(local_weathering) / colour(key frame's), limited to [1/2, 2]; 1 where no cell stands.
/// 8 samples per cell, so that it changes within an eighth of a cell where two cells meet.
ColourMap weathering_tint(const scene::Scene& scene, int frame, std::span<const CellChoice> choices,
                          const GrassColour& colour);

}  // namespace wold::landscape
