#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "meadow/cells.h"
#include "scene/scene.h"

namespace wold::meadow {

/// Bends the blades that are drawn in cells (choose_cells()) by what they lean, where the scene's
/// grass moves in the wind: tips go where the lean puts them, feet stay as they grow. What the
/// nearest of the few states that meshes are made for leaves of the lean stays in `parts`. States
/// are the fewer the farther cells are from the frame's camera: none is off by 0.7 pixels.
void bend_blades(const scene::Scene& scene, const Heightfield& terrain, int frame,
                 std::vector<CellChoice>& cells);

/// By how many BladeBend::step_rad states may be apart where a metre covers `pixels_per_m`: a power
/// of two, or 0 where none need be bent. Between foot and tip a cantilever is 0.147 of its tip's
/// way from the straight line at most.
int steps_apart(double height_m, double pixels_per_m);

}  // namespace wold::meadow
