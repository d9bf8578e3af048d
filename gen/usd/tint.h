#pragma once

#include <glm/glm.hpp>

#include "landscape/landscape.h"

namespace wold::usd {

/// A mesh of blades as cells show it: USD's preview surface cannot look up the light at an
/// instance's place, so that there is a prototype for each step of light.
struct TintedBlades {
  int mesh = 0;        ///< index into Landscape::blade_meshes
  glm::ivec3 step{0};  ///< of tint_of()

  bool operator<(const TintedBlades& other) const;
};

/// What multiplies radiance at a step of red, green and blue: steps are eighths of an octave.
glm::dvec3 tint_of(const glm::ivec3& step);

/// The step that is nearest to a colour; each channel at least 2^-8.
glm::ivec3 nearest_step(const glm::dvec3& tint);

/// The mean of Landscape::light where a cell stands.
glm::dvec3 mean_light(const landscape::Landscape& landscape, const landscape::BladeCell& cell);

}  // namespace wold::usd
