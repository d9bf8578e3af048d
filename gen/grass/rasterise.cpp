#include "grass/rasterise.h"

#include <array>
#include <cmath>

#include "grass/texel_builder.h"

namespace wold::grass {
namespace {

constexpr float sigma_voxels = 0.6F;
constexpr float cut_voxels = 1.5F;

/// One axis of the voxels around a point: its own and both neighbours.
struct AxisReach {
  AxisReach(float place, int middle) {
    for (int i = 0; i < 3; ++i) {
      const float apart = place - (static_cast<float>(middle + i - 1) + 0.5F);
      distance2[i] = apart * apart;
    }
  }
  float distance2[3];
};

/// The voxels around a point and the share each of them gets.
class Footprint {
 public:
  Footprint(const glm::vec3& place, const TexelShape& shape) {
    const glm::ivec3 middle(glm::floor(place));
    const AxisReach x(place.x, middle.x);
    const AxisReach y(place.y, middle.y);
    const AxisReach z(place.z, middle.z);
    const int own_column = shape.wrapped(middle.x);
    const int own_row = shape.wrapped(middle.y);
    for (int k = 0; k < 3; ++k) {
      const int height = middle.z + k - 1;
      if (height < 0 || height >= shape.height) continue;
      for (int j = 0; j < 3; ++j) {
        const std::uint32_t line = shape.linear(0, neighbour(own_row, j - 1, shape.side), height);
        for (int i = 0; i < 3; ++i) {
          const float distance2 = x.distance2[i] + y.distance2[j] + z.distance2[k];
          if (distance2 > cut_voxels * cut_voxels) continue;
          const int column = neighbour(own_column, i - 1, shape.side);
          voxel_[count_] = line + static_cast<std::uint32_t>(column);
          distance2_[count_++] = distance2;
        }
      }
    }
  }

  template <class Visit>
  void each_voxel(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i) visit(voxel_[i]);
  }
  /// Gaussian weights, normalised: a point's mass is kept wherever it stands.
  template <class Visit>
  void each_share(const Visit& visit) const {
    std::array<float, 27> weight;
    float sum = 0.0F;
    for (std::size_t i = 0; i < count_; ++i) {
      weight[i] = std::exp(distance2_[i] * (-0.5F / (sigma_voxels * sigma_voxels)));
      sum += weight[i];
    }
    for (std::size_t i = 0; i < count_; ++i) visit(voxel_[i], weight[i] / sum);
  }

 private:
  /// The place `step` voxels on, in a row that wraps.
  static int neighbour(int place, int step, int side) {
    const int next = place + step;
    return next < 0 ? next + side : next >= side ? next - side : next;
  }

  std::array<std::uint32_t, 27> voxel_;
  std::array<float, 27> distance2_;
  std::size_t count_ = 0;
};

}  // namespace

Texel rasterise_points(const Points& points, const TexelShape& shape) {
  const auto per_voxel = static_cast<float>(1.0 / shape.voxel_m);
  const auto each_point = [&](const auto& visit) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.area_m2[i] > 0.0F) visit(i, Footprint(points.position_m[i] * per_voxel, shape));
  };
  TexelBuilder builder(shape);
  each_point([&](std::size_t, const Footprint& footprint) {
    footprint.each_voxel([&](std::uint32_t voxel) { builder.mark(voxel); });
  });
  builder.prepare();
  each_point([&](std::size_t i, const Footprint& footprint) {
    const Contribution point{points.area_m2[i], points.tangent[i], points.normal[i],
                             points.albedo[i], points.specular[i]};
    footprint.each_share(
        [&](std::uint32_t voxel, float share) { builder.add(voxel, share, point); });
  });
  return builder.build();
}

}  // namespace wold::grass
