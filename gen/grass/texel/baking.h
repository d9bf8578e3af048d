#pragma once

#include <span>
#include <vector>

#include "grass/mechanics/dynamics.h"
#include "grass/optics/shading.h"
#include "grass/texel/volume_data.h"

namespace wold::grass {

/// Makes a texel ready to render: its extinction fitted to the coverage of the blades of all the
/// samples it stands for, shaded for the given quarter-turns of the sun, and reduced to coarser
/// levels, each fitted to the finest. One volume per entry of `sides` (finest first, the texel's
/// own side).
std::vector<VolumeData> bake_lods(const Texel& texel, std::span<const PointDynamics> samples,
                                  const Lighting& lighting, const FibreLook& look,
                                  std::span<const int> sides, const std::vector<int>& turns);

/// Source radiance per voxel of a texel that stands turned by `turn` quarter-turns, sunlight and
/// all other light through the tiled texel and scattered by it. `density`: its extinction.
std::vector<glm::vec3> bake_emission(const Texel& texel, const std::vector<float>& density,
                                     const Lighting& lighting, const FibreLook& look, int turn);

}  // namespace wold::grass
