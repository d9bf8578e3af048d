#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "grass/texel/texel.h"

namespace wold::grass {

/// What a voxel of a slice gets of a bit of grass.
struct VoxelWeight {
  std::uint32_t ground;  ///< the voxel's place within its slice, y * side + x
  float area_m2;
};

/// Four numbers that are added and multiplied at once.
using Four = float __attribute__((vector_size(16)));

/// What is summed up for a voxel besides its area: by area, the dyad of the tangent, the normal,
/// the albedo, the transmittance and the specular coefficient. The dyad's zz is missing: tangents
/// are unit, so that its trace is the area.
class Moments {
 public:
  /// Nothing when written Moments(); left open where thousands are about to be set.
  Moments() = default;
  /// Those of one square metre.
  Moments(const glm::vec3& t, const glm::vec3& n, const glm::vec3& md, const glm::vec3& through,
          float ms)
      : sum_{Four{t.x * t.x, t.y * t.y, t.x * t.y, t.x * t.z}, Four{t.y * t.z, n.x, n.y, n.z},
             Four{md.x, md.y, md.z, ms}, Four{through.x, through.y, through.z, 0.0F}} {}

  void add(const Moments& per_area, float by_area_m2) {
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += by_area_m2 * per_area.sum_[i];
  }
  /// The sums, in fours as they are kept.
  const Four& four(std::size_t k) const { return sum_[k]; }

 private:
  std::array<Four, 4> sum_;  ///< xx, yy, xy, xz; yz, normal; albedo, specular; transmittance
};

/// Writes the means that sums over voxels of these areas stand for into the texel, from `begin` on.
///
/// They are weighted by area, so a constant field stays constant. Tangents are averaged as dyads
/// t t^T, whose main axis, turned upwards, is the mean fibre: t and -t do not cancel. Normals point
/// outwards and are averaged as vectors; where they come from both sides of a vein the mean is
/// short, and zero, the vein's, is written.
void write_means(std::span<const Moments> sums, std::span<const VoxelWeight> areas,
                 std::size_t begin, Texel& texel);

}  // namespace wold::grass
