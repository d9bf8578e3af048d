#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "meadow/cells.h"
#include "scene/scene.h"

namespace wold::meadow {

/// Each of light_detail_steps_m() shows light as far from the eye as so many of them: a step covers
/// 1.8 pixels there, in a picture of 1920 pixels that sees 55 degrees. It bounds a map's samples.
constexpr double light_detail_reach_steps = 1000.0;

/// Steps of the light on the grass near the eye, coarse to fine, where place::window_grid() is too
/// coarse for the smallest tussocks of the sward: each is a third of the one before it, the last
/// one 10 cm at most. None on terrains that are not place::is_large().
std::vector<double> light_detail_steps_m(const scene::Scene& scene);

/// Grids of these steps. Each holds the cells of `cells` that it reaches from the eye, as
/// square_of_cells() does. Their corners lie on whole steps: samples of the same step lie at the
/// same places wherever the eye is. A grid that reaches no cell is left out, and so are finer ones.
/// `eye_m` and the ground are in world space.
std::vector<GroundGrid> light_detail_grids(const scene::Scene& scene,
                                           std::span<const CellChoice> cells,
                                           const Heightfield& terrain, const glm::dvec3& eye_m);

/// How finely the light on cells is shown, the same on both sides of a border between two of its
/// maps: they would differ in contrast, and under a low sun in brightness.
class ShownSteps {
 public:
  ShownSteps(const scene::Scene& scene, const glm::dvec3& eye_m);

  /// The step at a place: it rises with the distance from the eye up to place::window_grid()'s, and
  /// is nowhere less than that of the map that reaches there.
  double at(const glm::dvec3& place_m) const;

 private:
  glm::dvec3 eye_m_;
  double coarsest_m_;
};

}  // namespace wold::meadow
