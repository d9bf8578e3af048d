#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

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
    const glm::dvec2 one_m = unsheared(corner_m(part.low));
    const glm::dvec2 other_m = unsheared(corner_m(part.high));
    low_m_ = glm::min(one_m, other_m);
    high_m_ = glm::max(one_m, other_m);
  }

  /// Where a place, or a direction, would be if the sheared sides ran along x; there the footprint
  /// is the rectangle from low_m() to high_m().
  glm::dvec2 unsheared(const glm::dvec2& at) const { return {at.x, at.y - shear_ * at.x}; }
  const glm::dvec2& low_m() const { return low_m_; }
  const glm::dvec2& high_m() const { return high_m_; }

  bool contains(const glm::dvec2& at_m) const {
    const glm::dvec2 back_m = unsheared(at_m);
    return glm::all(glm::greaterThanEqual(back_m, low_m_)) &&
           glm::all(glm::lessThan(back_m, high_m_));
  }

  /// The least rectangle along the axes around what of it lies from `west_m` to `east_m`.
  std::pair<glm::dvec2, glm::dvec2> bounds_m(double west_m, double east_m) const {
    const double west = std::max(west_m, low_m_.x), east = std::min(east_m, high_m_.x);
    return {{west, low_m_.y + std::min(shear_ * west, shear_ * east)},
            {east, high_m_.y + std::max(shear_ * west, shear_ * east)}};
  }
  std::pair<glm::dvec2, glm::dvec2> bounds_m() const { return bounds_m(low_m_.x, high_m_.x); }

  /// visit(square) for each square of a grid with a corner at 0 that it reaches into.
  template <class Visit>
  void each_square(double side_m, const Visit& visit) const {
    const double within_m = 1e-6 * side_m;  // borders do not count for the next square
    const auto square = [&](double at_m) { return static_cast<int>(std::floor(at_m / side_m)); };
    for (int i = square(low_m_.x + within_m); i <= square(high_m_.x - within_m); ++i) {
      const auto [low_m, high_m] = bounds_m(i * side_m, (i + 1) * side_m);
      for (int j = square(low_m.y + within_m); j <= square(high_m.y - within_m); ++j)
        visit(glm::ivec2(i, j));
    }
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
