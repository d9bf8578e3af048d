#pragma once

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/ground.h"

namespace wold::place {

/// The ground of a scene, scene_ground(), and what grows where cells are laid on it: growth_map(),
/// of a large terrain in the CellWindow alone.
struct GrowingGround {
  terrain::Ground ground;
  FactorMap growth_of_cells;
};

/// Throws what terrain::make_ground() and growth_map() throw.
GrowingGround growing_ground(const scene::Scene& scene);

}  // namespace wold::place
