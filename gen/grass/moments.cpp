#include "grass/moments.h"

#include <algorithm>
#include <cmath>

namespace wold::grass {
namespace {

/// Normals, averaged, are shorter than this where they come from both sides of a vein: the vein.
constexpr float vein_normal = 0.2F;

/// Keeps quotients finite where there is nothing.
constexpr float tiny = 1e-30F;

constexpr std::size_t block = 64;
using Row = std::array<float, block>;

/// So many voxels, an array for each of their numbers: GCC makes the loops over them, which have
/// neither branches nor calls, do four voxels at once.
struct Block {
  Row per_area;                ///< 1 / m^2
  Row xx, yy, zz, xy, xz, yz;  ///< dyads
  Row nx, ny, nz;              ///< normals
};

/// Mean dyads and normals.
void load(std::span<const Moments> sums, std::span<const VoxelShare> areas, Block& b) {
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const float per_area = 1.0F / areas[i].area_m2;
    b.per_area[i] = per_area;
    b.xx[i] = per_area * sums[i][Moments::xx];
    b.yy[i] = per_area * sums[i][Moments::yy];
    b.zz[i] = 1.0F - b.xx[i] - b.yy[i];
    b.xy[i] = per_area * sums[i][Moments::xy];
    b.xz[i] = per_area * sums[i][Moments::xz];
    b.yz[i] = per_area * sums[i][Moments::yz];
    b.nx[i] = per_area * sums[i][Moments::normal];
    b.ny[i] = per_area * sums[i][Moments::normal + 1];
    b.nz[i] = per_area * sums[i][Moments::normal + 2];
  }
}

void square_dyads(Block& b) {
  for (std::size_t i = 0; i < block; ++i) {
    const float xx = b.xx[i], yy = b.yy[i], zz = b.zz[i];
    const float xy = b.xy[i], xz = b.xz[i], yz = b.yz[i];
    b.xx[i] = xx * xx + xy * xy + xz * xz;
    b.yy[i] = xy * xy + yy * yy + yz * yz;
    b.zz[i] = xz * xz + yz * yz + zz * zz;
    b.xy[i] = xy * (xx + yy) + xz * yz;
    b.xz[i] = xz * (xx + zz) + xy * yz;
    b.yz[i] = yz * (yy + zz) + xy * xz;
  }
}

/// Vectors in place of dyads: each times its longest column, which is never orthogonal to its main
/// axis. They stand in xx, yy and zz.
void times_longest_column(Block& b) {
  for (std::size_t i = 0; i < block; ++i) {
    const float xx = b.xx[i], yy = b.yy[i], zz = b.zz[i];
    const float xy = b.xy[i], xz = b.xz[i], yz = b.yz[i];
    const bool first = xx >= yy && xx >= zz;
    const bool second = yy >= zz;
    const float x = first ? xx : second ? xy : xz;
    const float y = first ? xy : second ? yy : yz;
    const float z = first ? xz : second ? yz : zz;
    b.xx[i] = xx * x + xy * y + xz * z;
    b.yy[i] = xy * x + yy * y + yz * z;
    b.zz[i] = xz * x + yz * y + zz * z;
  }
}

/// Scales vectors to length one, those not longer than `least` to nothing.
void normalise(Row& x, Row& y, Row& z, float least) {
  for (std::size_t i = 0; i < block; ++i) {
    const float squares = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
    const float inverse = 1.0F / std::sqrt(squares + tiny);
    const float scale = squares > least * least ? inverse : 0.0F;
    x[i] *= scale;
    y[i] *= scale;
    z[i] *= scale;
  }
}

void turn_upwards(Row& x, Row& y, Row& z) {
  for (std::size_t i = 0; i < block; ++i) {
    const float up = z[i] < 0.0F ? -1.0F : 1.0F;
    x[i] *= up;
    y[i] *= up;
    z[i] *= up;
  }
}

/// Main axes in place of dyads, in xx, yy and zz: the eighth step of the power iteration. A blade's
/// own voxels are one fibre, for which the first is exact.
void dyads_to_tangents(Block& b) {
  square_dyads(b);
  square_dyads(b);
  times_longest_column(b);
  normalise(b.xx, b.yy, b.zz, 0.0F);
  turn_upwards(b.xx, b.yy, b.zz);
}

void store(const Block& b, std::span<const Moments> sums, std::size_t begin, Texel& texel) {
  for (std::size_t i = 0; i < sums.size(); ++i) {
    texel.tangent[begin + i] = {b.xx[i], b.yy[i], b.zz[i]};
    texel.normal[begin + i] = {b.nx[i], b.ny[i], b.nz[i]};
    texel.albedo[begin + i] =
        b.per_area[i] * glm::vec3(sums[i][Moments::albedo], sums[i][Moments::albedo + 1],
                                  sums[i][Moments::albedo + 2]);
    texel.specular[begin + i] = b.per_area[i] * sums[i][Moments::specular];
  }
}

}  // namespace

void write_means(std::span<const Moments> sums, std::span<const VoxelShare> areas,
                 std::size_t begin, Texel& texel) {
  Block b{};
  for (std::size_t at = 0; at < sums.size(); at += block) {
    const std::size_t count = std::min(block, sums.size() - at);
    const auto part = sums.subspan(at, count);
    load(part, areas.subspan(at, count), b);
    dyads_to_tangents(b);
    normalise(b.nx, b.ny, b.nz, vein_normal);
    store(b, part, begin + at, texel);
  }
}

}  // namespace wold::grass
