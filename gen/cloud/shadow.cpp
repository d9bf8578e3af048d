#include "cloud/shadow.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// Optical depth of all layers on the way from a place to the sun.
double depth_to_sun(const CloudState& state, const glm::dvec3& from_m,
                    const glm::dvec3& sun_direction) {
  double depth = 0.0;
  for (const LayerState& layer : state.layers) {
    const double rise_m = layer.layer->base_m - from_m.z;
    if (rise_m < 0.0) continue;  // the place is above the layer
    const glm::dvec2 meets_m =
        glm::dvec2(from_m) + glm::dvec2(sun_direction) * (rise_m / sun_direction.z);
    depth += optical_depth_at(layer, state.pixel_m, meets_m) / sun_direction.z;
  }
  return depth;
}

}  // namespace

FactorMap sun_share(const CloudState& state, const Heightfield& terrain,
                    const glm::dvec3& sun_direction, int samples) {
  FactorMap share(samples, terrain.size_m(), 1.0F);
  if (state.layers.empty()) return share;
  parallel_for(static_cast<std::size_t>(samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples; ++i) {
      const double x_m = i * share.step_m(), y_m = j * share.step_m();
      const glm::dvec3 place(x_m, y_m, static_cast<double>(terrain.sample(x_m, y_m)));
      share.at(i, j) = static_cast<float>(std::exp(-depth_to_sun(state, place, sun_direction)));
    }
  });
  return share;
}

}  // namespace wold::cloud
