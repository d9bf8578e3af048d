#pragma once

#include "scene/scene.h"
#include "terrain/ground.h"

namespace wold::place {

/// The ground of a scene, terrain::make_ground(). What is finer than its heights, and the scree
/// that lies on that, are large terrains' alone.
terrain::Ground scene_ground(const scene::Scene& scene);

}  // namespace wold::place
