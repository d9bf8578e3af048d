#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "meadow/cells.h"
#include "scene/scene.h"

namespace wold::meadow {

/// Steps of the light on the grass near the eye, coarse to fine, where place::window_grid() is too
/// coarse for the smallest tussocks of the sward: each is a third of the one before it. None on
/// terrains that are not place::is_large().
std::vector<double> light_detail_steps_m(const scene::Scene& scene);

/// Each of these steps shows light as far from the eye as so many of them.
constexpr double light_detail_reach_steps = 1000.0;

/// Grids of these steps. Each holds the cells of `cells` that it reaches from `eye_m`, as
/// square_of_cells() does. Their corners lie on whole steps, so that light stays where it is while
/// the eye moves. A grid that reaches no cell is left out, and so are finer ones.
std::vector<GroundGrid> light_detail_grids(const scene::Scene& scene,
                                           std::span<const CellChoice> cells,
                                           const glm::dvec2& eye_m);

}  // namespace wold::meadow
