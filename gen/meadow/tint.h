#pragma once

#include <functional>
#include <span>

#include "core/ground_map.h"
#include "meadow/cells.h"
#include "place/withering.h"
#include "scene/scene.h"

namespace wold::meadow {

/// The mean colour of grass (linear RGB) at a weathering degree in [0, 1] under the fraction, in
/// [0, 1], of the snow it can carry.
using GrassColour = std::function<glm::vec3(double weathering, double snow)>;

/// A factor for light on grass that takes the squares out of a withering or whitening meadow:
/// cells show one key frame and level of snow each, while the ground wants the withering there and
/// the frame's canopy_snow(), `snow`. Inside a cell the factor is what is wanted over what is
/// shown, in `colour`, limited to [1/2, 2]; 1 where no cell stands. On `grid`; with 8
/// samples per cell it changes within an eighth of a cell where two cells meet.
ColourMap weathering_tint(const scene::Scene& scene, const place::Withering& withering, int frame,
                          std::span<const CellChoice> choices, double snow,
                          const GrassColour& colour, const GroundGrid& grid);

}  // namespace wold::meadow
