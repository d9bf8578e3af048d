#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "grass/texel.h"

namespace wold::grass {

/// Parallel rays through a tiled texel, one per ground voxel, all at once.
///
/// The box is sheared so that the direction becomes vertical; a sweep over its slices then adds
/// every voxel to the ray through it with one vector addition per row. Cost: one addition per
/// voxel and sub-slice; flat rays cross several voxels in a slice, which is then cut into as many
/// sub-slices. The shear is rounded to whole voxels, once, not step by step, so nothing diffuses.
class Columns {
 public:
  /// direction: towards the light or the eye, unit, z > 0. Rays are taken in every `stride`-th row.
  Columns(const TexelShape& shape, const glm::dvec3& direction, int stride = 1);

  /// One sub-slice on the way down: its slice, the path length inside, and where it stands
  /// sheared.
  struct Slab {
    int z;
    bool upper_half;  ///< above the slice's middle
    double length_m;
    int shift_x;  ///< voxel x of ray u is wrapped(u + shift_x)
    int shift_y;
  };
  /// Every slab from the top down.
  const std::vector<Slab>& slabs() const { return slabs_; }

  /// Calls row(ray, voxel, count) for runs of rays that meet runs of voxels in a slab: `ray`
  /// indexes the rays (side per row, rows() of them), `voxel` the dense box.
  template <class Row>
  void each_row(const Slab& slab, const Row& row) const {
    const int side = shape_.side;
    const int x = shape_.wrapped(slab.shift_x);
    for (int r = 0; r < rows(); ++r) {
      const int y = shape_.wrapped(r * stride_ + slab.shift_y);
      const std::size_t ray = static_cast<std::size_t>(r) * static_cast<std::size_t>(side);
      const std::size_t line = shape_.linear(0, y, slab.z);
      const auto head = static_cast<std::size_t>(side - x);
      row(ray, line + static_cast<std::size_t>(x), head);
      row(ray + head, line, static_cast<std::size_t>(x));
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

/// The box's densities, zero where there is nothing.
std::vector<float> dense_density(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
                                 const std::vector<float>& density);

/// Unit direction at an elevation and an azimuth from +x, radians.
glm::dvec3 direction_at(double elevation, double azimuth);

/// Optical depth of every ray through the tiled box.
std::vector<float> optical_depths(const TexelShape& shape, const std::vector<float>& dense,
                                  const glm::dvec3& direction, int stride = 1);

/// Transmittance from outside to every listed voxel (ascending dense order). The last `skip`
/// slices before the voxel do not count: they hold the blade the voxel belongs to, and a fibre of
/// the Kajiya-Kay model does not shadow itself.
std::vector<float> voxel_transmittance(const TexelShape& shape, const std::vector<float>& dense,
                                       const std::vector<std::uint32_t>& voxel,
                                       const glm::dvec3& direction, int skip);

/// Mean radiance that leaves the tiled box towards `direction`; `emission` per listed voxel.
glm::dvec3 mean_radiance(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
                         const std::vector<float>& density, const std::vector<glm::vec3>& emission,
                         const glm::dvec3& direction, int stride = 1);

}  // namespace wold::grass
