#include "grass/rasterise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "grass/texel_builder.h"

namespace wold::grass {
namespace {

constexpr float sigma_voxels = 0.6F;

/// exp(-d^2 / (2 sigma^2)) for the voxel `middle`, which `place` lies in, and its two neighbours.
std::array<float, 3> gaussian(float place, int middle) {
  std::array<float, 3> weight;
  for (int i = 0; i < 3; ++i) {
    const float apart = place - (static_cast<float>(middle + i - 1) + 0.5F);
    weight[static_cast<std::size_t>(i)] =
        std::exp(apart * apart * (-0.5F / (sigma_voxels * sigma_voxels)));
  }
  return weight;
}

float sum(const std::array<float, 3>& weight) { return weight[0] + weight[1] + weight[2]; }

/// What both neighbours get.
float outer(const std::array<float, 3>& weight) { return weight[0] + weight[2]; }

/// The 3^3 voxels around a point but for the eight corners: a Gaussian in space is the product of
/// one for each axis.
struct Footprint {
  std::uint32_t point;
  std::array<std::uint32_t, 3> column;  ///< x of the voxels
  std::array<std::uint32_t, 3> line;    ///< place of their rows in the slice
  std::array<float, 3> x, y, z;         ///< weights; without the corners they sum to one

  /// The shares of the slice `up` (0 to 2) of the three.
  std::size_t shares(std::size_t up, std::array<VoxelShare, 9>& result) const {
    std::size_t count = 0;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        if (up == 1 || i == 1 || j == 1)
          result[count++] = {line[j] + column[i], z[up] * y[j] * x[i]};
    return count;
  }
};

Footprint footprint(const glm::vec3& position_m, const TexelShape& shape) {
  const glm::vec3 place = position_m * static_cast<float>(1.0 / shape.voxel_m);
  const glm::ivec2 middle(glm::floor(glm::vec2(place)));
  const int slice = shape.slice(place.z);
  Footprint result;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    result.column[at] = static_cast<std::uint32_t>(shape.wrapped(middle.x + i - 1));
    result.line[at] = shape.linear(0, shape.wrapped(middle.y + i - 1), 0);
  }
  result.x = gaussian(place.x, middle.x);
  result.y = gaussian(place.y, middle.y);
  result.z = gaussian(std::clamp(place.z, 0.0F, static_cast<float>(shape.height)), slice);
  if (slice == 0) result.z[0] = 0.0F;
  if (slice + 1 == shape.height) result.z[2] = 0.0F;
  const float corners = outer(result.x) * outer(result.y) * outer(result.z);
  const float whole = sum(result.x) * sum(result.y) * sum(result.z) - corners;
  for (float& weight : result.z) weight /= whole;
  return result;
}

/// The points of a texel, ordered by the slice they lie in.
class PointContributions : public Contributions {
 public:
  PointContributions(const Points& points, const TexelShape& shape)
      : points_(points), begin_(static_cast<std::size_t>(shape.height) + 1, 0) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.area_m2[i] > 0.0F) ++begin_[slice(i, shape) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next = begin_;
    std::vector<std::uint32_t> order(begin_.back());
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (points.area_m2[i] > 0.0F) order[next[slice(i, shape)]++] = i;
    footprints_.resize(order.size());
    parallel_for_blocks(order.size(), [&](std::size_t i) {
      footprints_[i] = footprint(points.position_m[order[i]], shape);
      footprints_[i].point = order[i];
    });
  }

  void each_in_slice(int z, const Visit& visit) const override {
    std::array<VoxelShare, 9> shares;
    const int slices = static_cast<int>(begin_.size()) - 1;
    for (int own = std::max(z - 1, 0); own < std::min(z + 2, slices); ++own) {
      const auto begin = begin_[static_cast<std::size_t>(own)];
      const auto end = begin_[static_cast<std::size_t>(own) + 1];
      for (std::size_t at = begin; at < end; ++at) {
        const Footprint& around = footprints_[at];
        const std::size_t count = around.shares(static_cast<std::size_t>(z - own + 1), shares);
        visit(around.point, {shares.data(), count});
      }
    }
  }
  float area_m2(std::size_t which) const override { return points_.area_m2[which]; }
  Contribution contribution(std::size_t which) const override {
    return {points_.area_m2[which], points_.tangent[which], points_.normal[which],
            points_.albedo[which], points_.specular[which]};
  }

 private:
  std::size_t slice(std::size_t point, const TexelShape& shape) const {
    return static_cast<std::size_t>(
        shape.slice(points_.position_m[point].z * static_cast<float>(1.0 / shape.voxel_m)));
  }

  const Points& points_;
  std::vector<std::size_t> begin_;  ///< first footprint of each slice, and the end
  std::vector<Footprint> footprints_;
};

}  // namespace

Texel rasterise_points(const Points& points, const TexelShape& shape) {
  double area_m2 = 0.0;
  for (float area : points.area_m2) area_m2 += double{area};
  return build_texel(shape, PointContributions(points, shape), area_m2);
}

}  // namespace wold::grass
