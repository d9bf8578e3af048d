#pragma once

#include <array>
#include <functional>
#include <span>

#include "grass/texel.h"

namespace wold::grass {

/// A bit of grass that is spread over voxels.
struct Contribution {
  float area_m2 = 0.0F;
  glm::vec3 tangent;
  glm::vec3 normal;
  glm::vec3 albedo;
  float specular = 0.0F;
};

/// Part of a contribution that one voxel of a slice gets.
struct VoxelShare {
  std::uint32_t ground;  ///< the voxel's place within its slice, y * side + x
  float share;
};

/// Contributions a texel is made of, slice by slice. Walked through twice for every slice, and for
/// several slices at once; always in the same order, because sums depend on it.
class Contributions {
 public:
  virtual ~Contributions() = default;

  using Visit = std::function<void(std::size_t which, std::span<const VoxelShare> shares)>;
  /// Calls visit for every contribution that reaches the slice at height z.
  virtual void each_in_slice(int z, const Visit& visit) const = 0;
  virtual float area_m2(std::size_t which) const = 0;
  virtual Contribution contribution(std::size_t which) const = 0;
};

/// Gathers weighted contributions into a texel. Slices are made independently, each in two passes:
/// areas first, then, for the voxels that are bright enough to be seen, everything else. A meadow
/// touches four times as many voxels as it fills visibly, and a slice stays in the processor's
/// cache.
///
/// Density is a sum; every other attribute is the mean weighted by area, so a constant field stays
/// constant. Tangents are averaged as dyads t t^T, whose main axis is the mean fibre: t and -t do
/// not cancel. Normals point outwards and are averaged as vectors. Voxels too faint to see
/// (visible.h) are left out and their area is given to the others, in proportion; when all are
/// faint, all are kept. `area_m2` is that of all contributions together.
Texel build_texel(const TexelShape& shape, const Contributions& contributions, double area_m2);

/// Unit main axis of the dyad (xx, yy, zz, xy, xz, yz), turned upwards; (0, 0, 1) for none.
glm::vec3 main_axis(const std::array<float, 6>& dyad);

}  // namespace wold::grass
