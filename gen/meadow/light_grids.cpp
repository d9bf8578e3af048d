#include "meadow/light_grids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "place/cell_window.h"
#include "place/ground_grids.h"
#include "place/view.h"

namespace wold::meadow {
namespace {

constexpr double finer = 3.0;  ///< the steps of a map over those of the next one

/// Beyond which the grass of cells that stand within `distance_m` of the eye does not reach.
std::optional<Square> square_near(const scene::Scene& scene, std::span<const CellChoice> cells,
                                  const Heightfield& terrain, const glm::dvec3& eye_m,
                                  double distance_m) {
  constexpr int none = std::numeric_limits<int>::max();
  glm::ivec2 low(none), high(-none);
  for (const CellChoice& choice : cells) {
    const glm::dvec2 middle_m = (glm::dvec2(choice.cell) + 0.5) * scene.grass.patch_m;
    const glm::dvec3 place_m = place::above_ground(terrain, middle_m, 0.0);
    if (glm::distance(place_m, eye_m) > distance_m) continue;
    low = glm::min(low, choice.cell);
    high = glm::max(high, choice.cell);
  }
  if (low.x == none) return std::nullopt;
  return square_of_cells(scene, low, high);
}

/// The least grid of that step, on whole steps, that covers a square.
GroundGrid grid_over(const Square& square, double step_m) {
  const glm::dvec2 corner_m = glm::floor(square.corner_m / step_m) * step_m;
  const glm::dvec2 ends_m = square.corner_m + square.size_m - corner_m;
  const double steps = std::ceil(std::max(ends_m.x, ends_m.y) / step_m);
  return {{corner_m, steps * step_m}, static_cast<int>(steps) + 1};
}

}  // namespace

std::vector<double> light_detail_steps_m(const scene::Scene& scene) {
  constexpr double fine_enough_m = 0.1;
  std::vector<double> steps_m;
  if (!place::is_large(scene)) return steps_m;
  for (double step_m = place::window_grid(scene).step_m(); step_m > fine_enough_m;)
    steps_m.push_back(step_m /= finer);
  return steps_m;
}

std::vector<GroundGrid> light_detail_grids(const scene::Scene& scene,
                                           std::span<const CellChoice> cells,
                                           const Heightfield& terrain, const glm::dvec3& eye_m) {
  std::vector<GroundGrid> grids;
  for (const double step_m : light_detail_steps_m(scene)) {
    const std::optional<Square> square =
        square_near(scene, cells, terrain, eye_m, light_detail_reach_steps * step_m);
    if (!square) break;
    grids.push_back(grid_over(*square, step_m));
  }
  return grids;
}

ShownSteps::ShownSteps(const scene::Scene& scene, const glm::dvec3& eye_m)
    : eye_m_(eye_m), coarsest_m_(place::window_grid(scene).step_m()) {}

double ShownSteps::at(const glm::dvec3& place_m) const {
  return std::min(finer / light_detail_reach_steps * glm::distance(place_m, eye_m_), coarsest_m_);
}

}  // namespace wold::meadow
