#include "terrain/resampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wold::terrain {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::array<double, 4> linear_weights(double t) { return {0.0, 1.0 - t, t, 0.0}; }

/// Those that are no void count.
struct Sum {
  double values = 0.0;
  double weights = 0.0;
  bool has_void = false;
  void add(double value, double weight) {
    if (std::isnan(value)) {
      has_void = true;
    } else {
      values += weight * value;
      weights += weight;
    }
  }
};

Sum sum_around(const CellBlock& block, const glm::ivec2& cell, const std::array<double, 4>& across,
               const std::array<double, 4>& down) {
  Sum sum;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      sum.add(block.at(cell + glm::ivec2(column - 1, row - 1)),
              across[static_cast<std::size_t>(column)] * down[static_cast<std::size_t>(row)]);
  return sum;
}

/// Of the cells -2 to 2 in the mean over cell 0 of what cubic convolution makes of them: its
/// weights, integrated.
constexpr std::array<double, 5> mean_weights = {-5.0 / 384, 36.0 / 384, 322.0 / 384, 36.0 / 384,
                                                -5.0 / 384};

/// That mean; NaN beside voids and at the block's border.
double mean_of_cubic(const CellBlock& block, const glm::ivec2& cell) {
  double mean = 0.0;
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 5; ++column)
      mean += mean_weights[static_cast<std::size_t>(column)] *
              mean_weights[static_cast<std::size_t>(row)] *
              block.at(cell + glm::ivec2(column - 2, row - 2));
  return mean;
}

}  // namespace

std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * ((2.0 - t) * t - 1.0), 0.5 * (t * t * (3.0 * t - 5.0) + 2.0),
          0.5 * t * ((4.0 - 3.0 * t) * t + 1.0), 0.5 * t * t * (t - 1.0)};
}

double CellBlock::at(const glm::ivec2& cell) const {
  const glm::ivec2 in = cell - first;
  if (in.x < 0 || in.y < 0 || in.x >= size.x || in.y >= size.y) return nothing;
  return values[static_cast<std::size_t>(in.y) * static_cast<std::size_t>(size.x) +
                static_cast<std::size_t>(in.x)];
}

CellBlock with_means_kept(const CellBlock& means) {
  CellBlock block = means;
  for (int pass = 0; pass < mean_passes; ++pass) {
    const CellBlock before = block;
    for (std::size_t k = 0; k < block.values.size(); ++k) {
      const auto at = static_cast<int>(k);
      const glm::ivec2 cell = block.first + glm::ivec2(at % block.size.x, at / block.size.x);
      const double wrong = means.values[k] - mean_of_cubic(before, cell);
      if (!std::isnan(wrong)) block.values[k] += wrong;
    }
  }
  return block;
}

double cubic_value(const CellBlock& block, const glm::dvec2& place) {
  if (!(std::abs(place.x) < 1e9 && std::abs(place.y) < 1e9)) return nothing;
  if (std::isnan(block.at(glm::ivec2(glm::floor(place))))) return nothing;
  const glm::dvec2 from_middle = place - 0.5;
  const glm::dvec2 whole = glm::floor(from_middle);
  const glm::dvec2 t = from_middle - whole;
  const glm::ivec2 cell(whole);
  const Sum cubic = sum_around(block, cell, cubic_weights(t.x), cubic_weights(t.y));
  if (!cubic.has_void) return cubic.values;
  const Sum linear = sum_around(block, cell, linear_weights(t.x), linear_weights(t.y));
  return linear.values / linear.weights;
}

double mean_value(const CellBlock& block, const glm::dvec2& low, const glm::dvec2& high) {
  const glm::dvec2 from = glm::max(low, glm::dvec2(block.first));
  const glm::dvec2 to = glm::min(high, glm::dvec2(block.first + block.size));
  Sum sum;
  if (!(from.x < to.x && from.y < to.y)) return nothing;
  for (int row = static_cast<int>(std::floor(from.y)); row < to.y; ++row) {
    const double height = std::min(row + 1.0, to.y) - std::max(1.0 * row, from.y);
    for (int column = static_cast<int>(std::floor(from.x)); column < to.x; ++column)
      sum.add(block.at({column, row}),
              height * (std::min(column + 1.0, to.x) - std::max(1.0 * column, from.x)));
  }
  return sum.weights > 0.0 ? sum.values / sum.weights : nothing;
}

}  // namespace wold::terrain
