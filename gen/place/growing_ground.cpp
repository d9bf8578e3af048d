#include "place/growing_ground.h"

#include <utility>

#include "place/cell_window.h"
#include "place/ground_grids.h"
#include "place/growth.h"
#include "place/scene_ground.h"
#include "terrain/surface.h"

namespace wold::place {

GrowingGround growing_ground(const scene::Scene& scene) {
  terrain::Ground ground = scene_ground(scene);
  const Heightfield& heights_m = ground.heights_m;
  FactorMap growth = is_large(scene)
                         ? growth_map(scene, terrain::Surface(heights_m, ground.finer.get(),
                                                              window_grid(scene), ground.known()))
                         : growth_map(scene, heights_m, ground.known());
  return {std::move(ground), std::move(growth)};
}

}  // namespace wold::place
