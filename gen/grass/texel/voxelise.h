#pragma once

#include <vector>

#include "grass/geometry/blade.h"
#include "grass/texel/texel.h"

namespace wold::grass {

/// What one blade leaves in one voxel.
struct BladeVoxel {
  glm::ivec3 voxel;        ///< not wrapped: a blade may cross the tile's border
  float area_m2 = 0.0F;    ///< mean projected area over all directions
  glm::vec3 normal{0.0F};  ///< unit, from the axis to the matter; zero where the vein runs
};

/// Voxelises a fresh, straight cone ([TVT] section 2.1), voxels in ascending (z, y, x).
///
/// A convex body shows a quarter of its surface on average (Cauchy), a thin cone of diameter d
/// therefore (pi / 4) d ds per length ds of its axis; the sum over the voxels is that of the cone.
std::vector<BladeVoxel> voxelise_blade(const Blade& blade, const TexelShape& shape);

/// Mean projected area of a fresh cone, m^2: (pi / 4) * length * radius.
double cone_area_m2(const Blade& blade);

}  // namespace wold::grass
