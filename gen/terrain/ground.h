#pragma once

#include <cstdint>
#include <memory>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/finer_relief.h"

namespace wold::terrain {

/// A scene's ground: heights in metres, and what is finer than their step.
struct Ground {
  Heightfield heights_m;
  std::shared_ptr<const FinerRelief>
      finer;  ///< none where the step is no coarser than soil's creep
};

/// The scene's ground: make_hillside(), make_mountain(), or the place of an elevation model when it
/// names one (elevation.h).
///
/// What was measured stays. Below the model's cells its relief goes on (FinerRelief) down to the
/// heights' step, unless terrain.relief is 0, and soil creeps (crept()). The same for any number of
/// threads. Throws what read_elevation() throws.
Ground make_ground(const scene::Terrain& terrain, std::uint64_t seed);

}  // namespace wold::terrain
