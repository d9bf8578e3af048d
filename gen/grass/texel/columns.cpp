#include "grass/texel/columns.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/elementary.h"
#include "core/interpolation.h"

namespace wold::grass {
namespace {

/// Adds the optical depth of one slab to every ray, and says to which and how much.
template <class Value, class Added>
void add_slab(const Columns& columns, const Columns::Slab& slab, const VoxelRows& voxels,
              const std::vector<Value>& extinction, std::vector<Value>& depth, const Added& added) {
  const auto length = static_cast<float>(slab.length_m);
  columns.each(slab, voxels, [&](std::size_t ray, std::size_t place) {
    depth[ray] += length * extinction[place];
    added(ray, length * extinction[place]);
  });
}

/// The depths of rays that come through patches beside this one, of which not all have what stands
/// high: once a ray has left such a patch, its depth is that which lets through what they do in the
/// mean.
class RaysFromBeside {
 public:
  RaysFromBeside(const TexelShape& shape, const Beside& beside, std::size_t rays)
      : shape_(shape), beside_(beside), high_(beside.share < 1.0 ? rays : 0, 0.0F) {}

  /// Before the depth of a slab is added.
  void enter(const Columns::Slab& slab, std::vector<float>& depth) {
    if (high_.empty()) return;
    if (slab_)
      for (int y = 0; y < shape_.side; ++y)
        for (int x = 0; x < shape_.side; ++x)
          if (crosses(x, slab_->shift_x, slab.shift_x) || crosses(y, slab_->shift_y, slab.shift_y))
            leave(shape_.linear(x, y, 0), depth);
    slab_ = slab;
  }
  /// Of a voxel that a ray comes through.
  void add(std::size_t ray, float depth) {
    if (!high_.empty() && slab_->z >= beside_.top) high_[ray] += depth;
  }
  /// By how much less deep a ray will be once it has left the patch that it is in.
  float thinned(std::size_t ray) const {
    if (high_.empty() || !(high_[ray] > 0.0F)) return 0.0F;
    const double through = std::lerp(1.0, double{math::exp(-high_[ray])}, beside_.share);
    return high_[ray] + static_cast<float>(math::log(through));
  }
  /// How far rays have been moved by now, voxels.
  glm::ivec2 shift() const {
    return slab_ ? glm::ivec2(slab_->shift_x, slab_->shift_y) : glm::ivec2(0);
  }

 private:
  int patch(int voxel) const { return (voxel - shape_.wrapped(voxel)) / shape_.side; }
  bool crosses(int voxel, int from, int to) const {
    return patch(voxel + from) != patch(voxel + to);
  }

  void leave(std::size_t ray, std::vector<float>& depth) {
    depth[ray] -= thinned(ray);
    high_[ray] = 0.0F;
  }

  const TexelShape& shape_;
  Beside beside_;
  std::vector<float> high_;  ///< depths of the patch that a ray is in, above its neighbours
  std::optional<Columns::Slab> slab_;
};

/// Writes what comes through to the voxels of a slice. `middle`: by how many voxels a ray is moved
/// there, between the ground and the middle of the slice. All its voxels' middles lie between the
/// same four rays, at the same place.
void read_slice(const VoxelRows& voxels, int z, const glm::dvec2& middle,
                const std::vector<float>& depth, const RaysFromBeside& from_beside,
                std::vector<float>& result) {
  const TexelShape& shape = voxels.shape();
  const glm::ivec2 shift(glm::ceil(middle));
  const glm::vec2 on(glm::dvec2(shift) - middle);
  // Rays that are read before they have come as far down may still be in a patch beside.
  const glm::ivec2 ahead = from_beside.shift() - shift;
  const auto is_inside = [&](int voxel) { return voxel >= 0 && voxel < shape.side; };
  std::vector<std::size_t> ray_of(static_cast<std::size_t>(shape.side) + 1);  // in a row
  for (std::size_t x = 0; x < ray_of.size(); ++x)
    ray_of[x] = static_cast<std::size_t>(shape.wrapped(static_cast<int>(x) - shift.x));
  const auto depth_at = [&](int x, int y, std::size_t row) {
    const std::size_t ray = row + ray_of[static_cast<std::size_t>(x)];
    const bool inside = is_inside(x + ahead.x) && is_inside(y + ahead.y);
    return inside ? depth[ray] : depth[ray] - from_beside.thinned(ray);
  };
  for (int y = 0; y < shape.side; ++y) {
    const std::size_t near = shape.linear(0, shape.wrapped(y - shift.y), 0);
    const std::size_t far = shape.linear(0, shape.wrapped(y + 1 - shift.y), 0);
    voxels.each(y, z, [&](int x, std::size_t place) {
      result[place] =
          math::exp(-bilinear(depth_at(x, y, near), depth_at(x + 1, y, near),
                              depth_at(x, y + 1, far), depth_at(x + 1, y + 1, far), on.x, on.y));
    });
  }
}

}  // namespace

VoxelRows::VoxelRows(const TexelShape& shape, std::span<const std::uint32_t> voxel)
    : shape_(shape), voxel_(voxel) {
  const auto rows = static_cast<std::uint32_t>(shape.side * shape.height);
  begin_.reserve(rows + 1);
  std::uint32_t next = 0;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    const std::uint32_t line = row * static_cast<std::uint32_t>(shape.side);
    while (next < voxel.size() && voxel[next] < line) ++next;
    begin_.push_back(next);
  }
}

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

glm::dvec3 direction_at(double elevation, double azimuth) {
  return {math::cos(elevation) * math::cos(azimuth), math::cos(elevation) * math::sin(azimuth),
          math::sin(elevation)};
}

template <class Value>
std::vector<Value> optical_depths(const VoxelRows& voxels, const std::vector<Value>& extinction,
                                  const glm::dvec3& direction, int stride) {
  const Columns columns(voxels.shape(), direction, stride);
  std::vector<Value> depth(columns.rays(), Value(0.0F));
  for (const Columns::Slab& slab : columns.slabs())
    add_slab(columns, slab, voxels, extinction, depth, [](std::size_t, const Value&) {});
  return depth;
}
template std::vector<float> optical_depths(const VoxelRows&, const std::vector<float>&,
                                           const glm::dvec3&, int);
template std::vector<glm::vec3> optical_depths(const VoxelRows&, const std::vector<glm::vec3>&,
                                               const glm::dvec3&, int);

std::vector<float> voxel_transmittance(const VoxelRows& voxels, const std::vector<float>& density,
                                       const glm::dvec3& direction, int skip,
                                       const Beside& beside) {
  const TexelShape& shape = voxels.shape();
  const Columns columns(shape, direction);
  const glm::dvec2 slope = glm::dvec2(direction) / direction.z;
  std::vector<float> depth(columns.rays(), 0.0F);
  RaysFromBeside from_beside(shape, beside, columns.rays());
  std::vector<float> result(voxels.size());
  int next = shape.height - 1;
  const auto read_down_to = [&](int z) {
    for (; next >= std::max(z, 0); --next)
      read_slice(voxels, next, slope * (next + 0.5), depth, from_beside, result);
  };
  read_down_to(shape.height - skip);
  for (const Columns::Slab& slab : columns.slabs()) {
    // Depths now reach down to the middle of the slab's slice.
    if (!slab.upper_half) read_down_to(slab.z - skip);
    from_beside.enter(slab, depth);
    add_slab(columns, slab, voxels, density, depth,
             [&](std::size_t ray, float added) { from_beside.add(ray, added); });
  }
  return result;
}

glm::dvec3 mean_radiance(const VoxelRows& voxels, const std::vector<float>& density,
                         const std::vector<glm::vec3>& emission, const glm::dvec3& direction,
                         int stride) {
  const Columns columns(voxels.shape(), direction, stride);
  std::vector<float> through(columns.rays(), 1.0F);
  glm::dvec3 sum(0.0);
  for (const Columns::Slab& slab : columns.slabs())
    columns.each(slab, voxels, [&](std::size_t ray, std::size_t place) {
      if (through[ray] < 1e-3F) return;
      const auto depth = static_cast<float>(double{density[place]} * slab.length_m);
      const float seen = through[ray] * -math::expm1(-depth);
      sum += glm::dvec3(seen * emission[place]);
      through[ray] -= seen;
    });
  return sum / static_cast<double>(columns.rays());
}

}  // namespace wold::grass
