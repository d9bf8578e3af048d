#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "landscape/aggregate_appearance.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// A way downwards through a patch, in cell space.
struct PatchRay {
  glm::dvec2 start{0.0};  ///< where it enters, in fractions of the patch
  glm::dvec3 direction;   ///< unit vector
  double begin = 0.5;  ///< length of the first step, in steps: the mean over all of [0, 1) is exact
  double top_m = std::numeric_limits<double>::infinity();  ///< enters there, or at the patch's top
  double floor_m = 0.0;                                    ///< ends there
  double thickness = 1.0;                                  ///< factor on all extinction
};

/// A baked volume in memory, 16 bytes a voxel. It repeats along x and y.
class TiledVolume {
 public:
  /// Reads its grids. Throws FileError.
  explicit TiledVolume(const Volume& volume);

  /// What is seen along a ray, in steps of a voxel.
  AggregateAppearance trace(const PatchRay& ray) const;

 private:
  std::size_t index(const glm::ivec3& at) const;

  glm::ivec3 voxels_;
  double voxel_m_;
  std::vector<float> extinction_;
  std::vector<glm::vec3> radiance_;
};

}  // namespace wold::landscape
