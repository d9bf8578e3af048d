#pragma once

#include <vector>

#include "grass/blade_patch.h"
#include "grass/shading.h"

namespace wold::grass {

/// About `count` fibres that stand for all of a patch: places at equal steps through its blades,
/// each where a blade has as much area towards the root as towards the tip, and half-way there and
/// beyond.
std::vector<Fibre> representative_fibres(const BladePatch& patch, const AgeingModel& model,
                                         int count);

}  // namespace wold::grass
