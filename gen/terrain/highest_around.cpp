#include "terrain/highest_around.h"

#include <algorithm>
#include <cmath>

namespace wold::terrain {
namespace {

constexpr int block = 8;  // cells along a side

/// Samples that count for a place beyond the corners of its cell.
constexpr int beyond = 1;

/// How far a convolution goes above its highest sample, over the span of all: the sum of the
/// negative ones of cubic_weights() along both axes, which is largest in the middle of a cell.
constexpr double overshoot = 2.0 * (9.0 / 8.0) * (1.0 / 8.0);

/// More than what is rounded away of any height.
double rounding_m(double height_m) { return 1e-3 + 1e-6 * std::abs(height_m); }

double highest_in(const Heightfield& map, int column, int row) {
  const int last = map.samples() - 1;
  const auto from = [](int k) { return std::max(k * block - beyond, 0); };
  const auto to = [&](int k) { return std::min((k + 1) * block + beyond, last); };
  double lowest_m = map.at(from(column), from(row)), highest_m = lowest_m;
  for (int j = from(row); j <= to(row); ++j)
    for (int i = from(column); i <= to(column); ++i) {
      lowest_m = std::min(lowest_m, double{map.at(i, j)});
      highest_m = std::max(highest_m, double{map.at(i, j)});
    }
  return highest_m + overshoot * (highest_m - lowest_m) + rounding_m(highest_m);
}

}  // namespace

HighestAround::HighestAround(const Heightfield& map)
    : corner_m_(map.corner_m()),
      block_m_(block * map.step_m()),
      blocks_((map.samples() - 2) / block + 1) {
  highest_m_.reserve(static_cast<std::size_t>(blocks_) * static_cast<std::size_t>(blocks_));
  for (int row = 0; row < blocks_; ++row)
    for (int column = 0; column < blocks_; ++column)
      highest_m_.push_back(highest_in(map, column, row));
}

double HighestAround::highest_m(const glm::dvec2& at_m) const {
  const glm::dvec2 place =
      glm::clamp((at_m - corner_m_) / block_m_, glm::dvec2(0.0), glm::dvec2(blocks_ - 1.0));
  return highest_m_[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(blocks_) +
                    static_cast<std::size_t>(place.x)];
}

double HighestAround::highest_m() const { return *std::ranges::max_element(highest_m_); }

}  // namespace wold::terrain
