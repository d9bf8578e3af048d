#include "usd/tint.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::usd {
namespace {

constexpr double steps_per_octave = 5.0;

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

int nearest_step(double value) {
  constexpr double least = 1.0 / 256.0;
  return static_cast<int>(std::lround(steps_per_octave * math::log2(std::max(value, least))));
}

LightStep nearest_step(const glm::dvec3& light) {
  const double all = brightness(light);
  return {nearest_step(all), all > 0.0 ? nearest_step(light.b / all) : 0};
}

}  // namespace

CellLight::CellLight(const landscape::Landscape& landscape) {
  std::map<LightStep, int> cells;
  for (const landscape::BladeCell& cell : landscape.blade_cells) {
    const glm::dvec3 light = mean_light(landscape, cell);
    const LightStep step = nearest_step(light);
    steps_.push_back(step);
    tints_.try_emplace(step, 0.0).first->second += light;
    ++cells[step];
  }
  for (auto& [step, tint] : tints_) tint /= cells.at(step);
}

}  // namespace wold::usd
