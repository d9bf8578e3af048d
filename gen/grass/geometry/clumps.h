#pragma once

#include <cstdint>
#include <vector>

#include "grass/geometry/blade.h"

namespace wold::grass {

/// Makes hairs of a patch's blades, as scene::Fur says: wet, the tips of neighbours meet in the
/// tip of their clump, which is combed over; dry, each stands by itself with the droop of a fresh
/// blade.
///
/// Nothing but what a blade is made of changes: a hair heads for its clump's tip and droops, by
/// [TVT]'s rule, as far as it takes to reach it; the loss of water takes that droop away. The
/// clumps belong to the variant: all its samples share them. Clumps wrap with the patch.
void clump(std::vector<Blade>& hairs, const scene::Physiology& physiology, double patch_m,
           std::uint64_t seed, int variant);

}  // namespace wold::grass
