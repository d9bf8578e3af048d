#include "usd/tint.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::usd {
namespace {

constexpr double steps_per_octave = 4.0;

double brightness(const glm::dvec3& colour) { return (colour.r + colour.g + colour.b) / 3.0; }

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

}  // namespace

CellLight::CellLight(const landscape::Landscape& landscape) {
  glm::dvec3 sum(0.0);
  for (const landscape::BladeCell& cell : landscape.blade_cells) {
    light_.push_back(mean_light(landscape, cell));
    sum += light_.back();
  }
  if (brightness(sum) > 0.0) hue_ = sum / brightness(sum);
}

int CellLight::step_of(std::size_t cell) const {
  constexpr double darkest = 1.0 / 256.0;
  const double octaves = math::log2(std::max(brightness(light_.at(cell)), darkest));
  return static_cast<int>(std::lround(steps_per_octave * octaves));
}

glm::dvec3 CellLight::tint_of(int step) const { return math::exp2(step / steps_per_octave) * hue_; }

}  // namespace wold::usd
