#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"

namespace wold {

/// Height at a place of the mesh that renderers make of a terrain: each square of samples is two
/// triangles, cut from south-west to north-east. Where samples lie far apart it differs from the
/// bilinear height by metres. Outside the terrain the border's height.
inline float mesh_height_m(const Heightfield& terrain, const glm::dvec2& at_m) {
  const glm::dvec2 place =
      glm::clamp((at_m - terrain.corner_m()) / terrain.step_m(), 0.0, terrain.samples() - 1.0);
  const glm::ivec2 first = glm::min(glm::ivec2(place), terrain.samples() - 2);
  const glm::vec2 inside(place - glm::dvec2(first));
  const float south_west = terrain.at(first.x, first.y);
  const float north_east = terrain.at(first.x + 1, first.y + 1);
  if (inside.x >= inside.y) {
    const float south_east = terrain.at(first.x + 1, first.y);
    return south_west + inside.x * (south_east - south_west) + inside.y * (north_east - south_east);
  }
  const float north_west = terrain.at(first.x, first.y + 1);
  return south_west + inside.y * (north_west - south_west) + inside.x * (north_east - north_west);
}

}  // namespace wold
