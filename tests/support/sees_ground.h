#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "core/mesh_height.h"

namespace wold::test {

/// Whether an eye sees a place just over the ground, by the mesh that renderers make of it, along a
/// straight line in steps of `step_m`.
inline bool sees_ground(const Heightfield& terrain, const glm::dvec3& eye_m, const glm::dvec2& at_m,
                        double step_m) {
  constexpr double over_m = 0.01;
  const glm::dvec3 to_m(at_m, double{mesh_height_m(terrain, at_m)} + over_m);
  const double steps = std::ceil(glm::length(to_m - eye_m) / step_m);
  for (double step = 1.0; step < steps; ++step) {
    const glm::dvec3 on_m = glm::mix(eye_m, to_m, step / steps);
    if (double{mesh_height_m(terrain, glm::dvec2(on_m))} > on_m.z) return false;
  }
  return true;
}

}  // namespace wold::test
