#pragma once

#include <functional>
#include <vector>

#include "core/ground_map.h"
#include "place/view.h"
#include "scene/scene.h"

namespace wold::place {

/// Whether something that shows the ground's pictures stands out of the terrain in a square.
using Stands = std::function<bool(const Square&)>;

/// A view for each of a frame's pictures of the ground: of the whole, and of its details, coarse to
/// fine. None is asked for what a finer one shows wholly.
std::vector<View> views_of_pictures(const View& view, const GroundGrid& whole,
                                    const std::vector<GroundGrid>& details, const Stands& stands);

/// What a frame (from 1) sees of a terrain's ground, or each camera of the film; none where it has
/// more than eight. The terrain has to outlive them.
View view_of_frame(const scene::Scene& scene, const Heightfield& terrain, int frame);
std::vector<View> views_of_film(const scene::Scene& scene, const Heightfield& terrain);

}  // namespace wold::place
