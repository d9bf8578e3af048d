#pragma once

#include <compare>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "landscape/landscape.h"

namespace wold::usd {

/// A mesh of blades as cells show it: USD's preview surface cannot look up the light at an
/// instance's place, so that there is a prototype for each step of light.
struct TintedBlades {
  int mesh = 0;  ///< index into Landscape::blade_meshes
  int step = 0;  ///< of brightness: quarters of an octave

  auto operator<=>(const TintedBlades&) const = default;
};

/// The light on a frame's blade cells: steps of brightness, and one hue for all.
class CellLight {
 public:
  explicit CellLight(const landscape::Landscape& landscape);

  /// The step that is nearest to the brightness of a cell, by its index.
  int step_of(std::size_t cell) const;

  /// What multiplies radiance at a step.
  glm::dvec3 tint_of(int step) const;

 private:
  std::vector<glm::dvec3> light_;  ///< mean of Landscape::light on each cell
  glm::dvec3 hue_{1.0};            ///< its channels' mean is 1
};

}  // namespace wold::usd
