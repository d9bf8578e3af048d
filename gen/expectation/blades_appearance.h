#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/tubes.h"
#include "landscape/aggregate_appearance.h"
#include "landscape/tiled_volume.h"

namespace wold::expectation {

/// What a mesh of blades shows where single blades cannot be told apart: they are taken as spread
/// evenly over the ground they stand on, in slices of height, and as turned to all sides.
class BladesAppearance {
 public:
  /// `ground_m2`: the area on which they stand.
  BladesAppearance(const Tubes& tubes, double ground_m2);

  /// What is seen along a ray. Where it starts and how its first step is long do not matter.
  landscape::AggregateAppearance trace(const landscape::PatchRay& ray) const;

 private:
  static constexpr int slices = 16;

  /// Of the blades' surface in a slice, each piece seen from both sides: half its area, times the
  /// horizontal and the vertical part of its normal; and the mean radiance.
  struct Slice {
    double upright_m2 = 0.0;
    double level_m2 = 0.0;
    glm::dvec3 radiance{0.0};
  };

  void add_quad(const std::array<glm::dvec3, 4>& corners_m, const glm::dvec3& radiance);

  double ground_m2_;
  double slice_m_;
  std::array<Slice, slices> slices_{};
};

}  // namespace wold::expectation
