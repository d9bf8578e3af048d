#include "grass/texel/moments.h"

#include <algorithm>
#include <cmath>

namespace wold::grass {
namespace {

/// Normals, averaged, are shorter than this where they come from both sides of a vein: the vein.
constexpr float vein_normal = 0.2F;

/// Keeps quotients finite where there is nothing.
constexpr float tiny = 1e-30F;

// Four voxels at a time, an entry of a Four for each.
struct Vectors {
  Four x, y, z;
};
struct Dyads {
  Four xx, yy, zz, xy, xz, yz;
};

Four sqrt(const Four& of) {
  return Four{std::sqrt(of[0]), std::sqrt(of[1]), std::sqrt(of[2]), std::sqrt(of[3])};
}

void transpose(std::array<Four, 4>& rows) {
  const auto& [a, b, c, d] = rows;
  const Four ab_front = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Four ab_back = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Four cd_front = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Four cd_back = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  rows = {__builtin_shufflevector(ab_front, cd_front, 0, 1, 4, 5),
          __builtin_shufflevector(ab_front, cd_front, 2, 3, 6, 7),
          __builtin_shufflevector(ab_back, cd_back, 0, 1, 4, 5),
          __builtin_shufflevector(ab_back, cd_back, 2, 3, 6, 7)};
}

Dyads squared(const Dyads& d) {
  return {d.xx * d.xx + d.xy * d.xy + d.xz * d.xz, d.xy * d.xy + d.yy * d.yy + d.yz * d.yz,
          d.xz * d.xz + d.yz * d.yz + d.zz * d.zz, d.xy * (d.xx + d.yy) + d.xz * d.yz,
          d.xz * (d.xx + d.zz) + d.xy * d.yz,      d.yz * (d.yy + d.zz) + d.xy * d.xz};
}

/// The dyads times their longest columns, which are never orthogonal to their main axes.
Vectors times_longest_column(const Dyads& d) {
  const auto first = (d.xx >= d.yy) & (d.xx >= d.zz);
  const auto second = d.yy >= d.zz;
  const Four x = first ? d.xx : second ? d.xy : d.xz;
  const Four y = first ? d.xy : second ? d.yy : d.yz;
  const Four z = first ? d.xz : second ? d.yz : d.zz;
  return {d.xx * x + d.xy * y + d.xz * z, d.xy * x + d.yy * y + d.yz * z,
          d.xz * x + d.yz * y + d.zz * z};
}

/// Scaled to length one; those not longer than `min` to nothing.
Vectors normalised(const Vectors& v, float min) {
  const Four squares = v.x * v.x + v.y * v.y + v.z * v.z;
  const Four scale = squares > min * min ? 1.0F / sqrt(squares + tiny) : Four{};
  return {scale * v.x, scale * v.y, scale * v.z};
}

/// Main axes, turned upwards: the eighth step of the power iteration. A blade's own voxels are one
/// fibre, for which the first is exact.
Vectors main_axes(const Dyads& dyads) {
  const Vectors axes = normalised(times_longest_column(squared(squared(dyads))), 0.0F);
  const Four up = axes.z < 0.0F ? Four{} - 1.0F : Four{} + 1.0F;
  return {up * axes.x, up * axes.y, up * axes.z};
}

glm::vec3 first_three(const Four& of) { return {of[0], of[1], of[2]}; }

void store(const Vectors& from, std::size_t count, glm::vec3* to) {
  std::array<Four, 4> rows{from.x, from.y, from.z, Four{}};
  transpose(rows);
  for (std::size_t i = 0; i < count; ++i) to[i] = first_three(rows[i]);
}

/// Up to four voxels.
void write_four(std::span<const Moments> sums, std::span<const VoxelWeight> areas,
                std::size_t begin, Texel& texel) {
  std::array<Four, 4> a, b;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t voxel = std::min(i, sums.size() - 1);
    const float per_area = 1.0F / areas[voxel].area_m2;
    a[i] = per_area * sums[voxel].four(0);
    b[i] = per_area * sums[voxel].four(1);
    const Four reflectance = per_area * sums[voxel].four(2);
    texel.albedo[begin + voxel] = first_three(reflectance);
    texel.specular[begin + voxel] = reflectance[3];
    texel.transmittance[begin + voxel] = first_three(per_area * sums[voxel].four(3));
  }
  transpose(a);
  transpose(b);
  const auto& [xx, yy, xy, xz] = a;
  const auto& [yz, nx, ny, nz] = b;
  store(main_axes({xx, yy, 1.0F - xx - yy, xy, xz, yz}), sums.size(), &texel.tangent[begin]);
  store(normalised({nx, ny, nz}, vein_normal), sums.size(), &texel.normal[begin]);
}

}  // namespace

void write_means(std::span<const Moments> sums, std::span<const VoxelWeight> areas,
                 std::size_t begin, Texel& texel) {
  for (std::size_t at = 0; at < sums.size(); at += 4) {
    const std::size_t count = std::min<std::size_t>(4, sums.size() - at);
    write_four(sums.subspan(at, count), areas.subspan(at, count), begin + at, texel);
  }
}

}  // namespace wold::grass
