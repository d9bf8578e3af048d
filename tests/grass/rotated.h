#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <numeric>
#include <vector>

#include "grass/texel/texel.h"

/// Quarter-turns, counter-clockwise seen from above.
namespace wold::grass::test {

template <class Vector>
Vector quarter_turned(const Vector& v) {
  return {-v.y, v.x, v.z};
}

/// Voxels after a quarter-turn, ascending, and which one each of them was before.
struct TurnedVoxels {
  std::vector<std::uint32_t> voxel;
  std::vector<std::size_t> from;
};

inline TurnedVoxels quarter_turned(const TexelShape& shape,
                                   const std::vector<std::uint32_t>& voxel) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t v : voxel) {
    const glm::ivec3 at = shape.coordinates(v);
    places.push_back(shape.linear(shape.side - 1 - at.y, at.x, at.z));
  }
  TurnedVoxels turned;
  turned.from.resize(voxel.size());
  std::iota(turned.from.begin(), turned.from.end(), std::size_t{0});
  std::sort(turned.from.begin(), turned.from.end(),
            [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  for (std::size_t from : turned.from) turned.voxel.push_back(places[from]);
  return turned;
}

inline Texel quarter_turned(const Texel& texel) {
  const TurnedVoxels turned = quarter_turned(texel.shape, texel.voxel);
  Texel result;
  result.shape = texel.shape;
  result.voxel = turned.voxel;
  for (std::size_t from : turned.from) {
    result.density.push_back(texel.density[from]);
    result.tangent.push_back(quarter_turned(texel.tangent[from]));
    result.normal.push_back(quarter_turned(texel.normal[from]));
    result.albedo.push_back(texel.albedo[from]);
    result.transmittance.push_back(texel.transmittance[from]);
    result.specular.push_back(texel.specular[from]);
  }
  return result;
}

}  // namespace wold::grass::test
