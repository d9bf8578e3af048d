#include "grass/rasterise.h"

#include <array>
#include <cmath>

#include "grass/texel_builder.h"

namespace wold::grass {
namespace {

constexpr float sigma_voxels = 0.5F;
constexpr float cut_voxels = 1.2F;

/// Gaussian weights of one axis: the point's own voxel and its two neighbours.
struct AxisWeights {
  AxisWeights(float place, int middle) {
    for (int i = 0; i < 3; ++i) {
      const float apart = place - (static_cast<float>(middle + i - 1) + 0.5F);
      distance2[i] = apart * apart;
      weight[i] = std::exp(distance2[i] * (-0.5F / (sigma_voxels * sigma_voxels)));
    }
  }
  float distance2[3];
  float weight[3];
};

/// The voxels around a point and the share each of them gets.
class Footprint {
 public:
  Footprint(const glm::vec3& place, const TexelShape& shape) {
    const glm::ivec3 middle(glm::floor(place));
    const AxisWeights x(place.x, middle.x);
    const AxisWeights y(place.y, middle.y);
    const AxisWeights z(place.z, middle.z);
    float sum = 0.0F;
    for (int k = 0; k < 3; ++k) {
      const int height = middle.z + k - 1;
      if (height < 0 || height >= shape.height) continue;
      for (int j = 0; j < 3; ++j) {
        const int row = shape.wrapped(middle.y + j - 1);
        for (int i = 0; i < 3; ++i) {
          if (x.distance2[i] + y.distance2[j] + z.distance2[k] > cut_voxels * cut_voxels) continue;
          const float weight = x.weight[i] * y.weight[j] * z.weight[k];
          voxel_[count_] = shape.linear(shape.wrapped(middle.x + i - 1), row, height);
          share_[count_++] = weight;
          sum += weight;
        }
      }
    }
    for (std::size_t i = 0; i < count_; ++i) share_[i] /= sum;
  }

  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i) visit(voxel_[i], share_[i]);
  }

 private:
  std::array<std::uint32_t, 27> voxel_;
  std::array<float, 27> share_;
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
    footprint.each([&](std::uint32_t voxel, float) { builder.mark(voxel); });
  });
  builder.prepare();
  each_point([&](std::size_t i, const Footprint& footprint) {
    const Contribution point{points.area_m2[i], points.tangent[i], points.normal[i],
                             points.albedo[i], points.specular[i]};
    footprint.each([&](std::uint32_t voxel, float share) { builder.add(voxel, share, point); });
  });
  return builder.build();
}

}  // namespace wold::grass
