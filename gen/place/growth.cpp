#include "place/growth.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "place/habitat.h"

namespace wold::place {
namespace {

/// 1 where the probability is above the noise; the mean stays the probability within `soft` / 2.
double grown(double probability, double noise) {
  constexpr double soft = 0.02;
  const double above = probability * (1.0 + soft) - noise;
  return std::clamp(above / soft, 0.0, 1.0);
}

}  // namespace

FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain) {
  constexpr double step_m = 0.05;
  return growth_map(scene, terrain,
                    {{.size_m = terrain.size_m()}, map_samples(terrain.size_m(), step_m)});
}

FactorMap growth_map(const scene::Scene& scene, const Heightfield& terrain,
                     const GroundGrid& grid) {
  const double shown = shown_fraction(scene.growth.feature_m, grid.step_m());
  const GrowthLimits limits(scene.growth, terrain);
  const Habitats habitats(scene, terrain);
  const Fbm ragged{random_bits({scene.seed, key_of("growth"), 0, key_of("tufts")}), 6, 0.35};
  const Tufts tufts(ragged, scene.growth.feature_m);
  FactorMap map(grid.samples, grid.square);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      const double probability = limits.probability(at_m) * habitats.any(at_m);
      const bool certain = probability <= 0.0 || probability >= 1.0 || shown <= 0.0;
      const double noise = certain ? 0.5 : tufts.at(at_m);
      map.at(i, j) = static_cast<float>(
          shown >= 1.0 ? grown(probability, noise)
                       : std::lerp(probability, grown(probability, noise), shown));
    }
  });
  return map;
}

}  // namespace wold::place
