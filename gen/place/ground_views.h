#pragma once

#include <vector>

#include "core/ground_map.h"
#include "place/view.h"
#include "scene/scene.h"

namespace wold::place {

/// A view for each of a frame's pictures of the ground: of the whole, and of its details, coarse to
/// fine. What a finer one shows wholly counts for none.
std::vector<View> views_of_pictures(const View& view, const GroundGrid& whole,
                                    const std::vector<GroundGrid>& details);

/// The views of the picture of all of a large terrain: of each camera of the film, or of a frame
/// (from 1). Empty where there are more than eight. The terrain has to outlive them.
std::vector<View> views_of_whole(const scene::Scene& scene, const Heightfield& terrain);
std::vector<View> views_of_whole(const scene::Scene& scene, const Heightfield& terrain, int frame);

}  // namespace wold::place
