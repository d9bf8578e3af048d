#include "usd/tint.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/elementary.h"

namespace wold::usd {
namespace {

constexpr double steps_per_octave = 8.0;

}  // namespace

bool TintedBlades::operator<(const TintedBlades& other) const {
  return std::tie(mesh, step.x, step.y, step.z) <
         std::tie(other.mesh, other.step.x, other.step.y, other.step.z);
}

glm::dvec3 tint_of(const glm::ivec3& step) {
  glm::dvec3 tint;
  for (int channel = 0; channel < 3; ++channel)
    tint[channel] = math::exp2(step[channel] / steps_per_octave);
  return tint;
}

glm::ivec3 nearest_step(const glm::dvec3& tint) {
  constexpr double darkest = 1.0 / 256.0;
  glm::ivec3 step;
  for (int channel = 0; channel < 3; ++channel)
    step[channel] = static_cast<int>(
        std::lround(steps_per_octave * math::log2(std::max(tint[channel], darkest))));
  return step;
}

glm::dvec3 mean_light(const landscape::Landscape& landscape, const landscape::BladeCell& cell) {
  constexpr int per_side = 4;
  glm::dvec3 sum(0.0);
  for (int j = 0; j < per_side; ++j)
    for (int i = 0; i < per_side; ++i) {
      const glm::dvec2 fraction =
          glm::mix(cell.part.low, cell.part.high, (glm::dvec2(i, j) + 0.5) / double{per_side});
      const glm::dvec3 at_m(cell.world_from_cell *
                            glm::dvec4(fraction * landscape.patch_m, 0.0, 1.0));
      sum += glm::dvec3(landscape.light.sample(at_m.x, at_m.y));
    }
  return sum / double{per_side * per_side};
}

}  // namespace wold::usd
