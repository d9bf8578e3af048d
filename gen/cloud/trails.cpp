#include "cloud/trails.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloud/texture_noise.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// A place along a trail, and what of the ice that fell there is left.
struct Step {
  double away;  ///< in trails' lengths
  double left;
};

/// Steps of two pixels on average, which grow with the way; length_px: of a trail.
std::vector<Step> steps_of_trail(double length_px) {
  constexpr double lengths = 3.5;
  constexpr double growth = 0.15;  // of ice in the head, before it fades
  const int count = std::max(static_cast<int>(std::ceil(0.5 * lengths * length_px)), 8);
  const auto away = [&](double step) {
    const double x = step / count;
    return lengths * x * (1.0 + x) / 2.0;
  };
  std::vector<Step> steps;
  for (int i = 0; i < count; ++i) {
    const double middle = away(i + 0.5);
    const double grown = -math::expm1(-middle / growth);
    steps.push_back({middle, grown * math::exp(-middle) * (away(i + 1) - away(i))});
  }
  return steps;
}

PeriodicMap<float> falling(const PeriodicMap<float>& heads, double contrast) {
  PeriodicMap<float> ice(heads.width(), heads.height());
  parallel_for_blocks(ice.values().size(), [&](std::size_t i) {
    ice.values()[i] = static_cast<float>(math::exp(contrast * double{heads.values()[i]}));
  });
  return ice;
}

}  // namespace

PeriodicMap<float> trailing(const PeriodicMap<float>& heads, const Trails& trails,
                            std::uint64_t key) {
  const PeriodicMap<float> ice = falling(heads, trails.contrast);
  const std::vector<Step> path = steps_of_trail(trails.length * heads.width());
  const glm::dvec2 downwind(math::sin(trails.heading_rad), math::cos(trails.heading_rad));
  const glm::dvec2 aside(downwind.y, -downwind.x);
  PeriodicMap<float> field(heads.width(), heads.height());
  parallel_for(static_cast<std::size_t>(field.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < field.width(); ++x) {
      const glm::dvec2 place((x + 0.5) / field.width(), (y + 0.5) / field.height());
      constexpr glm::ivec2 regions(2);
      const double bend =
          trails.bend * (1.0 + 0.5 * perlin(place * glm::dvec2(regions), key, regions));
      double sum = 0.0;
      for (const Step& step : path) {
        const glm::dvec2 head =
            place + trails.length * step.away * (downwind + bend * step.away * aside);
        sum += step.left * ice.sample(head.x, head.y);
      }
      field.at(x, y) = static_cast<float>(math::log(sum));
    }
  });
  return field;
}

}  // namespace wold::cloud
