#pragma once

#include "landscape/landscape.h"

namespace wold::meadow {

/// The tubes of a mesh that stand on a part of its patch of side `patch_m`, by the middle of their
/// lowest ring; what stands outside the patch belongs to the part next to it. Parts that tile the
/// patch have every tube once. May have none.
landscape::BladeMesh part_of(const landscape::BladeMesh& mesh, double patch_m,
                             const landscape::Part& part);

}  // namespace wold::meadow
