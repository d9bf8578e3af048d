#include "grass/columns.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wold::grass {
namespace {

/// Adds the optical depth of one slab to every ray.
void add_slab(const Columns& columns, const Columns::Slab& slab, const std::vector<float>& dense,
              std::vector<float>& depth) {
  const auto length = static_cast<float>(slab.length_m);
  columns.each_row(slab, [&](std::size_t ray, std::size_t voxel, std::size_t count) {
    float* to = depth.data() + ray;
    const float* from = dense.data() + voxel;
    for (std::size_t i = 0; i < count; ++i) to[i] += length * from[i];
  });
}

}  // namespace

Columns::Columns(const TexelShape& shape, const glm::dvec3& direction, int stride)
    : shape_(shape), stride_(stride) {
  if (!(direction.z > 0.0)) throw std::invalid_argument("rays through a texel must rise");
  const glm::dvec2 slope = glm::dvec2(direction) / direction.z;
  const double steepest = std::max(std::abs(slope.x), std::abs(slope.y));
  // Even, so that a slice's middle lies between two slabs.
  const int cuts = 2 * std::max(1, static_cast<int>(std::lround(steepest / 2.0)));
  for (int z = shape.height - 1; z >= 0; --z)
    for (int cut = cuts - 1; cut >= 0; --cut) {
      const double height = z + (cut + 0.5) / cuts;
      slabs_.push_back({z, 2 * cut >= cuts, shape.voxel_m / (cuts * direction.z),
                        static_cast<int>(std::lround(slope.x * height)),
                        static_cast<int>(std::lround(slope.y * height))});
    }
}

std::vector<float> dense_density(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
                                 const std::vector<float>& density) {
  std::vector<float> dense(shape.voxels(), 0.0F);
  for (std::size_t i = 0; i < voxel.size(); ++i) dense[voxel[i]] = density[i];
  return dense;
}

glm::dvec3 direction_at(double elevation, double azimuth) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

std::vector<float> optical_depths(const TexelShape& shape, const std::vector<float>& dense,
                                  const glm::dvec3& direction, int stride) {
  const Columns columns(shape, direction, stride);
  std::vector<float> depth(columns.rays(), 0.0F);
  for (const Columns::Slab& slab : columns.slabs()) add_slab(columns, slab, dense, depth);
  return depth;
}

std::vector<float> voxel_transmittance(const TexelShape& shape, const std::vector<float>& dense,
                                       const std::vector<std::uint32_t>& voxel,
                                       const glm::dvec3& direction, int skip) {
  const Columns columns(shape, direction);
  const glm::dvec2 slope = glm::dvec2(direction) / direction.z;
  std::vector<float> depth(columns.rays(), 0.0F);
  std::vector<float> result(voxel.size());
  auto next = static_cast<std::ptrdiff_t>(voxel.size()) - 1;
  const auto read_down_to = [&](int z) {
    for (; next >= 0; --next) {
      const glm::ivec3 at = shape.coordinates(voxel[static_cast<std::size_t>(next)]);
      if (at.z < z) return;
      const int shift_x = static_cast<int>(std::lround(slope.x * (at.z + 0.5)));
      const int shift_y = static_cast<int>(std::lround(slope.y * (at.z + 0.5)));
      const std::size_t ray =
          shape.linear(shape.wrapped(at.x - shift_x), shape.wrapped(at.y - shift_y), 0);
      result[static_cast<std::size_t>(next)] = std::exp(-depth[ray]);
    }
  };
  read_down_to(shape.height - skip);
  for (const Columns::Slab& slab : columns.slabs()) {
    // Depths now reach down to the middle of the slab's slice.
    if (!slab.upper_half) read_down_to(slab.z - skip);
    add_slab(columns, slab, dense, depth);
  }
  return result;
}

glm::dvec3 mean_radiance(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
                         const std::vector<float>& density, const std::vector<glm::vec3>& emission,
                         const glm::dvec3& direction, int stride) {
  const Columns columns(shape, direction, stride);
  std::vector<std::uint32_t> slot(shape.voxels(), 0);  // 0: empty, else 1 + place in the lists
  for (std::size_t i = 0; i < voxel.size(); ++i) slot[voxel[i]] = static_cast<std::uint32_t>(i) + 1;
  std::vector<float> through(columns.rays(), 1.0F);
  glm::dvec3 sum(0.0);
  for (const Columns::Slab& slab : columns.slabs())
    columns.each_row(slab, [&](std::size_t ray, std::size_t at, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = slot[at + i];
        if (place == 0 || through[ray + i] < 1e-3F) continue;
        const double depth = double{density[place - 1]} * slab.length_m;
        const double seen = double{through[ray + i]} * -std::expm1(-depth);
        sum += seen * glm::dvec3(emission[place - 1]);
        through[ray + i] -= static_cast<float>(seen);
      }
    });
  return sum / static_cast<double>(columns.rays());
}

}  // namespace wold::grass
