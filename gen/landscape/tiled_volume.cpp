#include "landscape/tiled_volume.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/vdb_dense.h"

namespace wold::landscape {

TiledVolume::TiledVolume(const Volume& volume)
    : voxels_(volume.voxels),
      voxel_m_(volume.voxel_m),
      extinction_(read_dense_floats(volume.vdb, "density", glm::ivec3(1), voxels_)),
      radiance_(read_dense_vectors(volume.vdb, volume.emission_grid, glm::ivec3(1), voxels_)) {}

AggregateAppearance TiledVolume::trace(const PatchRay& ray) const {
  constexpr double nothing_left = 1e-3;
  const double top = std::min(ray.top_m / voxel_m_, voxels_.z - 1e-6);
  const double floor = ray.floor_m / voxel_m_;
  const double step_m = ray.thickness * voxel_m_;
  AggregateAppearance look;
  glm::dvec3 at(ray.start * static_cast<double>(voxels_.x), top);
  for (at += ray.begin * ray.direction; at.z >= floor && look.transmittance > nothing_left;
       at += ray.direction) {
    const std::size_t voxel = index(glm::ivec3(glm::floor(at)));
    const double left = math::exp(-double{extinction_[voxel]} * step_m);
    look.radiance += look.transmittance * (1.0 - left) * glm::dvec3(radiance_[voxel]);
    look.transmittance *= left;
  }
  return look;
}

std::size_t TiledVolume::index(const glm::ivec3& at) const {
  const auto wrapped = [](int i, int n) { return static_cast<std::size_t>(((i % n) + n) % n); };
  const auto side = static_cast<std::size_t>(voxels_.x);
  return (static_cast<std::size_t>(at.z) * side + wrapped(at.y, voxels_.y)) * side +
         wrapped(at.x, voxels_.x);
}

}  // namespace wold::landscape
