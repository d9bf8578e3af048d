#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "grass/texel/texel.h"

namespace wold::grass {

/// A texel ready to be rendered: extinction, and the light it sends out for each quarter-turn of
/// the sun. Voxels ascending in dense order, as in Texel.
struct VolumeData {
  TexelShape shape;
  std::vector<std::uint32_t> voxel;
  std::vector<float> density;                    ///< extinction, 1/m
  std::vector<int> turns;                        ///< quarter-turns baked, ascending, each in 0..3
  std::vector<std::vector<glm::vec3>> emission;  ///< source radiance per turn and voxel

  std::size_t size() const { return voxel.size(); }
};

}  // namespace wold::grass
