#pragma once

#include "landscape/landscape.h"

namespace wold::landscape {

/// The tubes of a mesh that stand on a part of its patch of side `patch_m`, by the middle of their
/// lowest ring; what stands outside the patch belongs to the part next to it. Parts that tile the
/// patch have every tube once. May have none.
BladeMesh part_of(const BladeMesh& mesh, double patch_m, const Part& part);

}  // namespace wold::landscape
