#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "grass/texel/moments.h"
#include "grass/texel/texel.h"

namespace wold::grass {

/// e^x for |x| < 1.5, to three in ten million: the series for x / 4, which takes x, y and z at
/// once. Calls of std::exp would take a tenth of all the time.
template <class Value>
constexpr Value short_exp(Value x) {
  const Value q = 0.25F * x;
  Value sum = q * (1.0F / 5040.0F) + 1.0F / 720.0F;
  for (float next : {1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F})
    sum = q * sum + next;
  return (sum * sum) * (sum * sum);
}

/// The voxels before, at and after i, brought back into the tile.
inline std::array<std::uint32_t, 3> neighbours(int i, const TexelShape& shape) {
  const int middle = shape.wrapped(i);
  return {static_cast<std::uint32_t>(middle == 0 ? shape.side - 1 : middle - 1),
          static_cast<std::uint32_t>(middle),
          static_cast<std::uint32_t>(middle + 1 == shape.side ? 0 : middle + 1)};
}

/// std::floor, which is a function call where the build must run on any x86-64.
inline int floored(float value) {
  const auto towards_zero = static_cast<int>(value);
  return towards_zero - (value < static_cast<float>(towards_zero) ? 1 : 0);
}

/// How a point is spread over the 3^3 voxels around it but for the eight corners, with Gaussian
/// weights: a Gaussian in space is the product of one for each axis.
class Footprint {
 public:
  static constexpr float sigma_voxels = 0.6F;

  /// Left open, for thousands that are about to be made in their place.
  Footprint() = default;
  /// Of a point on the patch that stands for this area.
  Footprint(const glm::vec3& position_m, float area_m2, const TexelShape& shape) {
    const glm::vec3 place = position_m * static_cast<float>(1.0 / shape.voxel_m);
    const glm::ivec2 middle(floored(place.x), floored(place.y));
    const int slice = shape.slice(place.z);
    column_ = neighbours(middle.x, shape);
    line_ = neighbours(middle.y, shape);
    for (std::uint32_t& line : line_) line *= static_cast<std::uint32_t>(shape.side);
    const float height = std::clamp(place.z, 0.0F, static_cast<float>(shape.height));
    weigh(Four{place.x - static_cast<float>(middle.x), place.y - static_cast<float>(middle.y),
               height - static_cast<float>(slice)});
    if (slice == 0) below_[2] = 0.0F;
    if (slice + 1 == shape.height) above_[2] = 0.0F;
    const Four outer = below_ + above_;
    middle_m2_ = area_m2 / ((1.0F + outer[0]) * (1.0F + outer[1]) * (1.0F + outer[2]) -
                            outer[0] * outer[1] * outer[2]);
  }

  /// What the point's own slice gets.
  std::array<VoxelWeight, 9> own() const {
    const float before = middle_m2_ * below_[1];
    const float after = middle_m2_ * above_[1];
    return {{{line_[0] + column_[0], before * below_[0]},
             {line_[0] + column_[1], before},
             {line_[0] + column_[2], before * above_[0]},
             {line_[1] + column_[0], middle_m2_ * below_[0]},
             {line_[1] + column_[1], middle_m2_},
             {line_[1] + column_[2], middle_m2_ * above_[0]},
             {line_[2] + column_[0], after * below_[0]},
             {line_[2] + column_[1], after},
             {line_[2] + column_[2], after * above_[0]}}};
  }
  /// What the slices below and above it get.
  std::array<VoxelWeight, 5> below() const { return beside(middle_m2_ * below_[2]); }
  std::array<VoxelWeight, 5> above() const { return beside(middle_m2_ * above_[2]); }

 private:
  /// Weights of the neighbours in units of the middle one's, for a point `inside` its voxel:
  /// exp(-((d +- 1)^2 - d^2) / (2 sigma^2)), d off the middle.
  void weigh(const Four& inside) {
    constexpr float k = 1.0F / (2.0F * sigma_voxels * sigma_voxels);
    const Four upwards = short_exp<Four>(2.0F * k * (inside - 0.5F));
    above_ = short_exp(-k) * upwards;
    below_ = short_exp(-k) / upwards;
  }
  std::array<VoxelWeight, 5> beside(float m2) const {
    return {{{line_[0] + column_[1], m2 * below_[1]},
             {line_[1] + column_[0], m2 * below_[0]},
             {line_[1] + column_[1], m2},
             {line_[1] + column_[2], m2 * above_[0]},
             {line_[2] + column_[1], m2 * above_[1]}}};
  }

  Four below_, above_;                   ///< weights of the neighbours along x, y and z
  float middle_m2_;                      ///< what the point's own voxel gets
  std::array<std::uint32_t, 3> column_;  ///< x of the voxels
  std::array<std::uint32_t, 3> line_;    ///< place of their rows in the slice
};

}  // namespace wold::grass
