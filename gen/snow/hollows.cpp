#include "snow/hollows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace wold::snow {
namespace {

/// How much the ground bends up along one axis, m: the mean height on both sides of a place less
/// its own; 0 where one side is outside the map.
float bend_m(const Heightfield& terrain, const glm::dvec2& at_m, const glm::dvec2& away_m) {
  const glm::dvec2 before = at_m - away_m, after = at_m + away_m;
  if (std::min(before.x, before.y) < 0.0 || std::max(after.x, after.y) > terrain.size_m())
    return 0.0F;
  return 0.5F * (terrain.sample(before.x, before.y) + terrain.sample(after.x, after.y)) -
         terrain.sample(at_m.x, at_m.y);
}

}  // namespace

FactorMap hollows(const Heightfield& terrain, double feature_m) {
  const double away_m = std::max(feature_m, terrain.step_m());
  FactorMap result(terrain.samples(), terrain.size_m());
  parallel_for(static_cast<std::size_t>(terrain.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < terrain.samples(); ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * terrain.step_m();
      result.at(i, j) = bend_m(terrain, at_m, {away_m, 0.0}) + bend_m(terrain, at_m, {0.0, away_m});
    }
  });
  std::vector<float>& values = result.values();
  const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  const double deviation_m = std::sqrt(squares / static_cast<double>(values.size()));
  constexpr double flat_m = 1e-4;  // below it they are rounding
  for (float& value : values)
    value = deviation_m > flat_m ? static_cast<float>(value / deviation_m) : 0.0F;
  return result;
}

}  // namespace wold::snow
