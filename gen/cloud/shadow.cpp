#include "cloud/shadow.h"

#include <algorithm>
#include <cmath>

#include "cloud/layer_crossing.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// Optical depth of all layers on the way from a place to the sun.
double depth_to_sun(const CloudState& state, const glm::dvec3& from_m,
                    const glm::dvec3& sun_direction) {
  const double sine = std::max(sun_direction.z, 0.0);
  double depth = 0.0;
  for (const LayerState& layer : state.layers) {
    const double rise_m = layer.layer->base_m - from_m.z;
    if (rise_m <= 0.0) continue;  // the place is above the layer
    const auto [distance_m, cosine] = crossing(sine, rise_m);
    const glm::dvec2 meets_m = glm::dvec2(from_m) + glm::dvec2(sun_direction) * distance_m;
    depth += optical_depth_at(layer, state.pixel_m, meets_m) / cosine;
  }
  return depth;
}

}  // namespace

FactorMap sunlit_fraction(const CloudState& state, const Heightfield& terrain,
                          const glm::dvec3& sun_direction, int samples) {
  return sunlit_fraction(state, terrain, sun_direction, {{.size_m = terrain.size_m()}, samples});
}

FactorMap sunlit_fraction(const CloudState& state, const Heightfield& terrain,
                          const glm::dvec3& sun_direction, const GroundGrid& grid) {
  FactorMap fraction(grid.samples, grid.square, 1.0F);
  if (state.layers.empty()) return fraction;
  parallel_for(static_cast<std::size_t>(grid.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < grid.samples; ++i) {
      const glm::dvec2 at_m = fraction.place_m(i, j);
      const glm::dvec3 place(at_m, static_cast<double>(terrain.sample(at_m.x, at_m.y)));
      fraction.at(i, j) = static_cast<float>(math::exp(-depth_to_sun(state, place, sun_direction)));
    }
  });
  return fraction;
}

}  // namespace wold::cloud
