#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "landscape/landscape.h"

namespace wold::landscape {

/// The ground under a part of a cell: a rectangle along the axes, or a parallelogram, two of whose
/// sides point to the north.
class Footprint {
 public:
  Footprint() = default;

  /// `world_from_cell`: of a Cell or a BladeCell; `patch_m`: the side of a patch.
  Footprint(const glm::dmat4& world_from_cell, const Part& part, double patch_m)
      : shear_(shear_of(world_from_cell)) {
    const auto corner_m = [&](const glm::dvec2& fraction) {
      return glm::dvec2(world_from_cell * glm::dvec4(fraction * patch_m, 0.0, 1.0));
    };
    const glm::dvec2 one_m = sheared_back(corner_m(part.low));
    const glm::dvec2 other_m = sheared_back(corner_m(part.high));
    low_m_ = glm::min(one_m, other_m);
    high_m_ = glm::max(one_m, other_m);
  }

  /// Where a place, or a direction, would be if the sheared sides ran along x: there the footprint
  /// is the rectangle from low_m() to high_m().
  glm::dvec2 sheared_back(const glm::dvec2& at) const { return {at.x, at.y - shear_ * at.x}; }
  const glm::dvec2& low_m() const { return low_m_; }
  const glm::dvec2& high_m() const { return high_m_; }

  bool contains(const glm::dvec2& at_m) const {
    const glm::dvec2 back_m = sheared_back(at_m);
    return glm::all(glm::greaterThanEqual(back_m, low_m_)) &&
           glm::all(glm::lessThan(back_m, high_m_));
  }

  /// The least rectangle along the axes around it.
  glm::dvec2 south_west_m() const {
    return {low_m_.x, low_m_.y + std::min(shear_ * low_m_.x, shear_ * high_m_.x)};
  }
  glm::dvec2 north_east_m() const {
    return {high_m_.x, high_m_.y + std::max(shear_ * low_m_.x, shear_ * high_m_.x)};
  }

 private:
  /// To the north for each metre to the east, of the cell's axis that is no northern one.
  static double shear_of(const glm::dmat4& world_from_cell) {
    const bool turned = std::abs(world_from_cell[0].x) < std::abs(world_from_cell[1].x);
    const glm::dvec4& eastern = world_from_cell[turned ? 1 : 0];
    return eastern.x == 0.0 ? 0.0 : eastern.y / eastern.x;
  }

  double shear_ = 0.0;
  glm::dvec2 low_m_{0.0}, high_m_{0.0};
};

}  // namespace wold::landscape
