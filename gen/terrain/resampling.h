#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace wold::terrain {

/// Cells of a raster from `first` on, row by row southwards; voids are NaN.
struct CellBlock {
  glm::ivec2 first{0};
  glm::ivec2 size{0};
  std::vector<double> values;

  /// NaN beyond the block.
  double at(const glm::ivec2& cell) const;
};

/// Passes of with_means_kept(): after four, means are true to 2 % of what is finest. In each, what
/// lies up to two cells away counts.
inline constexpr int mean_passes = 4;

/// The values whose cubic convolution has the block's as the means of its cells. Elevation models
/// hold means: what they say is the ground seen through a cell's width, and this undoes that.
/// Values next to voids, and those at the block's border, stay as they are.
CellBlock with_means_kept(const CellBlock& means);

/// Cubic convolution [Keys1981] with a = -1/2: the weights of the values at -1, 0, 1 and 2 for a
/// place `t` between 0 and 1. They sum to 1.
std::array<double, 4> cubic_weights(double t);

/// A raster's value at a place, in cells from its upper left corner, by cubic convolution. Beside
/// voids, bilinear between the cells that are there; NaN in a void.
double cubic_value(const CellBlock& block, const glm::dvec2& place);

/// Mean of what lies between two corners, upper left and lower right, by the fraction of each cell;
/// NaN when all of it is void.
double mean_value(const CellBlock& block, const glm::dvec2& low, const glm::dvec2& high);

}  // namespace wold::terrain
