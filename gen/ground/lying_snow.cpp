#include "ground/lying_snow.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace wold::ground {
namespace {

FactorMap map_of(const snow::CoverLevel& level, std::vector<float> values) {
  FactorMap map(level.side, Square{level.first_m, (level.side - 1) * level.step_m});
  map.values() = std::move(values);
  return map;
}

/// How much of a level is seen: none along its border, all from a few steps inside; where it ends
/// at the whole's border, that is none.
float seen_fraction(const FactorMap& map, const FactorMap& whole, const glm::dvec2& at_m) {
  constexpr double soft_steps = 8.0;
  double inside_m = soft_steps * map.step_m();
  for (int axis = 0; axis < 2; ++axis) {
    const double low_m = map.corner_m()[axis];
    const double high_m = low_m + map.size_m();
    if (low_m > whole.corner_m()[axis]) inside_m = std::min(inside_m, at_m[axis] - low_m);
    if (high_m < whole.corner_m()[axis] + whole.size_m() - whole.step_m())
      inside_m = std::min(inside_m, high_m - at_m[axis]);
  }
  return static_cast<float>(std::max(inside_m, 0.0) / (soft_steps * map.step_m()));
}

}  // namespace

LyingSnow::LyingSnow(std::vector<snow::CoverLevel> levels) {
  const snow::CoverLevel& whole = levels.back();
  const double white = std::accumulate(whole.white.begin(), whole.white.end(), 0.0);
  none_ = !(white > 0.0);
  if (!none_)
    albedo_ = static_cast<float>(
        std::inner_product(whole.white.begin(), whole.white.end(), whole.albedo.begin(), 0.0) /
        white);
  for (snow::CoverLevel& level : levels)
    levels_.push_back(
        {map_of(level, std::move(level.depth_m)), map_of(level, std::move(level.white))});
}

float LyingSnow::sample(const glm::dvec2& at_m, FactorMap Level::*map) const {
  float value = (levels_.back().*map).sample(at_m.x, at_m.y);
  for (std::size_t level = levels_.size() - 1; level-- > 0;) {
    const FactorMap& finer = levels_[level].*map;
    const float seen = seen_fraction(finer, levels_.back().*map, at_m);
    if (seen <= 0.0F) break;  // finer ones lie inside
    value += (finer.sample(at_m.x, at_m.y) - value) * seen;
  }
  return value;
}

}  // namespace wold::ground
