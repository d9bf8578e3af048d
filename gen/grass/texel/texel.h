#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace wold::grass {

/// Extent of a texel: cubic voxels, `side` of them along x and y, which wrap, and `height` from
/// the ground up.
struct TexelShape {
  int side = 0;
  int height = 0;
  double voxel_m = 0.0;

  std::size_t slice_voxels() const {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  }
  std::size_t voxels() const { return slice_voxels() * static_cast<std::size_t>(height); }
  double patch_m() const { return side * voxel_m; }
  double voxel_volume_m3() const { return voxel_m * voxel_m * voxel_m; }
  /// Position in the dense order: x fastest, then y, then z. All coordinates inside.
  std::uint32_t linear(int x, int y, int z) const {
    return static_cast<std::uint32_t>((z * side + y) * side + x);
  }
  glm::ivec3 coordinates(std::uint32_t voxel) const {
    const int index = static_cast<int>(voxel);
    return {index % side, index / side % side, index / side / side};
  }
  /// The slice that a height lies in, given in voxels; the nearest one outside.
  int slice(float z_voxels) const { return std::clamp(static_cast<int>(z_voxels), 0, height - 1); }
  /// A coordinate beyond the tile's border, brought back.
  int wrapped(int i) const {
    if (i >= 0 && i < side) return i;
    const int rest = i % side;
    return rest < 0 ? rest + side : rest;
  }
  bool operator==(const TexelShape&) const = default;
};

/// Texel of Kajiya and Kay (1989), [TVT] section 2.1: density, frame and reflectance per voxel.
///
/// Only voxels that hold matter are kept, in ascending dense order, one array per attribute: a
/// meadow fills a few per cent of its box, and every pass over it reads whole cache lines. OpenVDB
/// grids are made of it where it goes to disk (texel_file.h).
struct Texel {
  TexelShape shape;
  std::vector<std::uint32_t> voxel;      ///< dense position
  std::vector<float> density;            ///< mean projected area per volume, 1/m
  std::vector<glm::vec3> tangent;        ///< unit, along the blade; t and -t are the same fibre
  std::vector<glm::vec3> normal;         ///< unit, from the vein outwards; zero on the vein
  std::vector<glm::vec3> albedo;         ///< diffuse coefficient md, linear RGB
  std::vector<glm::vec3> transmittance;  ///< what of the albedo leaves on the other side
  std::vector<float> specular;           ///< specular coefficient ms

  std::size_t size() const { return voxel.size(); }
  /// Projected area of everything in the texel, m^2.
  double area_m2() const {
    double sum = 0.0;
    for (float value : density) sum += value;
    return sum * shape.voxel_volume_m3();
  }
};

}  // namespace wold::grass
