#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "grass/texel/texel.h"

namespace wold::grass {

/// Where the rows of a box begin in the ascending list of its voxels that hold matter. A meadow
/// fills a few per cent of its box: sweeps over the list touch nothing else.
class VoxelRows {
 public:
  /// Keeps a view of `voxel`, which has to outlive it.
  VoxelRows(const TexelShape& shape, std::span<const std::uint32_t> voxel);

  const TexelShape& shape() const { return shape_; }
  std::size_t size() const { return voxel_.size(); }

  /// Calls visit(x, place in the list) for every voxel of a row.
  template <class Visit>
  void each(int y, int z, const Visit& visit) const {
    const std::uint32_t line = shape_.linear(0, y, z);
    const std::size_t row = line / static_cast<std::size_t>(shape_.side);
    for (std::uint32_t i = begin_[row]; i < begin_[row + 1]; ++i)
      visit(static_cast<int>(voxel_[i] - line), std::size_t{i});
  }

 private:
  TexelShape shape_;
  std::span<const std::uint32_t> voxel_;
  std::vector<std::uint32_t> begin_;
};

/// Parallel rays through a tiled texel, one per ground voxel, all at once.
///
/// The box is sheared so that the direction becomes vertical; a sweep over its slices from the top
/// down then adds every voxel that holds matter to the ray through it. Flat rays cross several
/// voxels in a slice, which is then cut into as many slabs. The shear is rounded to whole voxels,
/// once, not step by step, so nothing diffuses.
class Columns {
 public:
  /// direction: towards the light or the eye, unit, z > 0. Rays are taken in every `stride`-th row.
  Columns(const TexelShape& shape, const glm::dvec3& direction, int stride = 1);

  /// One slab on the way down: its slice, the path length inside, and where it stands sheared.
  struct Slab {
    int z;
    bool upper_half;  ///< above the slice's middle
    double length_m;
    int shift_x;  ///< voxel x of ray u is wrapped(u + shift_x)
    int shift_y;
  };
  /// Every slab from the top down.
  const std::vector<Slab>& slabs() const { return slabs_; }

  /// Calls visit(ray, place of the voxel in its list) for every ray that meets matter in a slab.
  template <class Visit>
  void each(const Slab& slab, const VoxelRows& voxels, const Visit& visit) const {
    const int shift = shape_.wrapped(slab.shift_x);
    for (int r = 0; r < rows(); ++r) {
      const int first = r * shape_.side - shift;
      voxels.each(shape_.wrapped(r * stride_ + slab.shift_y), slab.z,
                  [&](int x, std::size_t place) {
                    const int ray = first + x + (x < shift ? shape_.side : 0);
                    visit(static_cast<std::size_t>(ray), place);
                  });
    }
  }

  int rows() const { return (shape_.side + stride_ - 1) / stride_; }
  std::size_t rays() const {
    return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(shape_.side);
  }

 private:
  TexelShape shape_;
  int stride_;
  std::vector<Slab> slabs_;
};

/// Unit direction at an elevation and an azimuth from +x, radians.
glm::dvec3 direction_at(double elevation, double azimuth);

/// Optical depth of every ray through the tiled box, for the extinction of each voxel; with a
/// vector per voxel, three depths at once.
template <class Value>
std::vector<Value> optical_depths(const VoxelRows& voxels, const std::vector<Value>& extinction,
                                  const glm::dvec3& direction, int stride = 1);

/// What stands beside a patch, whose light comes through patches like it: a shrub amid grass has
/// grass around it, not shrubs.
struct Beside {
  int top = 0;         ///< slices; what stands higher is not beside every patch
  double share = 1.0;  ///< of the patches beside it that have that, too
};

/// Transmittance from outside to every voxel. The last `skip` slices before the voxel do not
/// count: they hold the blade the voxel belongs to, and a fibre of the Kajiya-Kay model does not
/// shadow itself.
std::vector<float> voxel_transmittance(const VoxelRows& voxels, const std::vector<float>& density,
                                       const glm::dvec3& direction, int skip,
                                       const Beside& beside = {});

/// Mean radiance that leaves the tiled box towards `direction`; density and emission per voxel.
glm::dvec3 mean_radiance(const VoxelRows& voxels, const std::vector<float>& density,
                         const std::vector<glm::vec3>& emission, const glm::dvec3& direction,
                         int stride = 1);

}  // namespace wold::grass
