#pragma once

#include <compare>
#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "landscape/landscape.h"

namespace wold::usd {

/// Light in steps of a fifth of an octave.
struct LightStep {
  int brightness = 0;
  int blueness = 0;  ///< blue as a share of the brightness: places differ in how much sky they see

  auto operator<=>(const LightStep&) const = default;
};

/// A mesh of blades as cells show it: USD's preview surface cannot look up the light at an
/// instance's place, so that there is a prototype for each step of light.
struct TintedBlades {
  int mesh = 0;  ///< index into Landscape::blade_meshes
  LightStep step{};

  auto operator<=>(const TintedBlades&) const = default;
};

/// The light on a frame's blade cells, in steps.
class CellLight {
 public:
  explicit CellLight(const landscape::Landscape& landscape);

  /// The step that is nearest to the light on a cell, by its index.
  LightStep step_of(std::size_t cell) const { return steps_.at(cell); }

  /// What multiplies radiance at a step: the mean of its cells. Throws std::out_of_range for a step
  /// that no cell has.
  glm::dvec3 tint_of(const LightStep& step) const { return tints_.at(step); }

 private:
  std::vector<LightStep> steps_;
  std::map<LightStep, glm::dvec3> tints_;
};

}  // namespace wold::usd
