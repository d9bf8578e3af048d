#pragma once

#include <vector>

#include "scene/rule.h"
#include "scene/scene.h"

namespace wold::scene {

/// Adds a problem for each shot that contradicts the scene: a name that another one has, a day in a
/// scene without a season or none in one, a day beyond the season, a moment at night, and for what
/// says the film's frames beside the shots: ageing.frames, season.frames.
void report_shot_contradictions(const Scene& scene, const Places& places,
                                std::vector<Problem>& problems);

}  // namespace wold::scene
