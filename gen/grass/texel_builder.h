#pragma once

#include <vector>

#include "grass/texel.h"
#include "grass/voxel_set.h"

namespace wold::grass {

/// What one contribution adds to a voxel.
struct Contribution {
  float area_m2 = 0.0F;
  glm::vec3 tangent;
  glm::vec3 normal;
  glm::vec3 albedo;
  float specular = 0.0F;
};

/// Gathers weighted contributions into a texel in two passes over the same contributions: mark()
/// every voxel that will be touched, prepare(), then add(). Two passes keep the sums compact: 64
/// bytes per voxel that holds matter, nothing for the others.
///
/// Density is a sum; every other attribute is the mean weighted by area, so a constant field stays
/// constant. Tangents are averaged as dyads t t^T, whose main axis is the mean fibre: t and -t do
/// not cancel. Normals point outwards and are averaged as vectors.
class TexelBuilder {
 public:
  explicit TexelBuilder(const TexelShape& shape);

  /// x and y are wrapped by the caller; z within the texel.
  void mark(std::uint32_t voxel) { touched_.insert(voxel); }
  void prepare();
  void add(std::uint32_t voxel, float share, const Contribution& what);
  /// Voxels too faint to see are left out and their area is given to the others, in proportion;
  /// when all are faint, all are kept.
  Texel build() const;

 private:
  /// One cache line.
  struct alignas(64) Sum {
    float area = 0.0F;
    float dyad[6] = {};  ///< xx, yy, zz, xy, xz, yz
    glm::vec3 normal{0.0F};
    glm::vec3 albedo{0.0F};
    float specular = 0.0F;
  };

  TexelShape shape_;
  VoxelSet touched_;
  std::vector<std::uint32_t> voxel_;
  std::vector<Sum> sums_;
};

/// Unit main axis of the dyad (xx, yy, zz, xy, xz, yz), turned upwards; (0, 0, 1) for none.
glm::vec3 main_axis(const float (&dyad)[6]);

}  // namespace wold::grass
