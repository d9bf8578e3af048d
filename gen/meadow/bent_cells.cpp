#include "meadow/bent_cells.h"

#include <cmath>

#include "meadow/cell_lattice.h"
#include "place/air.h"
#include "place/view.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

/// In cell space, as blades bend.
glm::dvec2 lean_of(const landscape::PlacedPart& part) {
  const glm::dmat4& world_from_cell = part.world_from_cell;
  return glm::inverse(glm::dmat2(world_from_cell)) * glm::dvec2(world_from_cell[2]);
}

/// A part of a cell that leans by so much less.
void straighten(const glm::dvec2& less, landscape::PlacedPart& part) {
  glm::dmat4& world_from_cell = part.world_from_cell;
  world_from_cell[2] -= less.x * world_from_cell[0] + less.y * world_from_cell[1];
}

bool are_blades(const scene::Scene& scene) {
  return scene.render.grass == scene::GrassForm::blades ||
         scene.render.grass == scene::GrassForm::automatic;
}

}  // namespace

int steps_apart(double height_m, double pixels_per_m) {
  constexpr double off_the_line = 0.147, max_off_px = 0.7;
  constexpr int most = 8;
  // The middle between four states is the farthest from all.
  const double apart_rad = std::sqrt(2.0) * max_off_px / (off_the_line * height_m * pixels_per_m);
  int steps = 1;
  while (steps < most && 2 * steps * grass::BladeBend::step_rad <= apart_rad) steps *= 2;
  return 2 * steps * grass::BladeBend::step_rad <= apart_rad ? 0 : steps;
}

void bend_blades(const scene::Scene& scene, const Heightfield& terrain, int frame,
                 std::vector<CellChoice>& cells) {
  if (!place::grass_waves(scene) || !are_blades(scene)) return;
  const place::View view(place::camera_of_frame(scene, terrain, frame), scene.render.size_px[0],
                         scene.render.size_px[1]);
  const double height_m = scene::mean_grass(scene).height_m;
  const CellLattice lattice(scene);
  for (CellChoice& cell : cells) {
    if (!cell.blades) continue;
    const glm::dvec2 middle_m = lattice.ground(cell.cell).middle_m;
    const int apart = steps_apart(
        height_m, view.pixels(1.0, place::above_ground(terrain, middle_m, 0.5 * height_m)));
    if (apart == 0) continue;
    cell.bend = grass::nearest_bend(lean_of(cell.parts.front()), apart);
    for (landscape::PlacedPart& part : cell.parts) straighten(grass::tip_lean(cell.bend), part);
  }
}

}  // namespace wold::meadow
