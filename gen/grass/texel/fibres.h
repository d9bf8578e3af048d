#pragma once

#include <vector>

#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// About `count` > 0 fibres that stand for a patch by area: of every so many blades the three in
/// the middles of the thirds of its area, with the snow on them. Petals count by their area, at the
/// tip of what carries them. Albedo is linear sRGB.
std::vector<Fibre> representative_fibres(const BladePatch& patch, const MeadowModel& model,
                                         int count);

}  // namespace wold::grass
