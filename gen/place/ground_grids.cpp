#include "place/ground_grids.h"

#include <algorithm>
#include <cmath>

#include "place/cell_window.h"
#include "place/view.h"

namespace wold::place {
namespace {

constexpr double finest_step_m = 0.01;
constexpr double ahead = 0.3;  ///< of a square's side, from the eye to its middle
constexpr int max_samples = 2049;

/// Side of the square inside one of that side. Near the eye grass covers most of the ground.
double finer_side_m(double side_m) {
  constexpr double covered_m = 150.0;
  return side_m > covered_m ? 0.5 * side_m : 0.25 * side_m;
}

/// Samples along a side for each pixel that a radian has: of all of the terrain, of a square of it.
constexpr double of_whole = 2.0, of_details = 1.5;

double needed_samples(const scene::Scene& scene, double per_pixel) {
  return std::ceil(per_pixel * pixels_per_radian(scene)) + 1.0;
}

int clamped(double samples) {
  return static_cast<int>(std::clamp<double>(samples, 65, max_samples));
}

/// Level direction of view; none when the camera looks straight down.
glm::dvec2 ahead_of(const landscape::Camera& camera) {
  const glm::dvec2 way_m(camera.target_m - camera.eye_m);
  const double length_m = glm::length(way_m);
  return length_m > 0.0 ? way_m / length_m : glm::dvec2(0.0);
}

}  // namespace

GroundGrid whole_grid(const scene::Scene& scene) {
  return {{.size_m = scene.terrain.size_m}, clamped(needed_samples(scene, of_whole))};
}

GroundGrid picture_grid(const scene::Scene& scene) {
  constexpr double usual_step_m = 0.03, min_step_m = 0.005;
  const double size_m = scene.terrain.size_m;
  const double samples =
      std::clamp<double>(needed_samples(scene, of_whole), map_samples(size_m, usual_step_m),
                         map_samples(size_m, min_step_m));
  return {{.size_m = size_m}, static_cast<int>(samples)};
}

GroundGrid snow_grid(const scene::Scene& scene) {
  constexpr double step_m = 0.02;
  GroundGrid grid = picture_grid(scene);
  grid.samples = std::max(grid.samples, map_samples(grid.square.size_m, step_m));
  return grid;
}

std::vector<GroundGrid> detail_grids(const scene::Scene& scene, const landscape::Camera& camera) {
  std::vector<GroundGrid> grids;
  if (!is_large(scene)) return grids;
  GroundGrid grid{whole_grid(scene).square, clamped(needed_samples(scene, of_details))};
  while (grid.step_m() > finest_step_m) {
    grid.square.size_m = finer_side_m(grid.square.size_m);
    const glm::dvec2 middle_m =
        glm::dvec2(camera.eye_m) + ahead * grid.square.size_m * ahead_of(camera);
    const glm::dvec2 corner = (middle_m - 0.5 * grid.square.size_m) / grid.step_m();
    grid.square.corner_m = glm::floor(corner) * grid.step_m();
    grids.push_back(grid);
  }
  return grids;
}

GroundGrid window_grid(const scene::Scene& scene) {
  constexpr double step_m = 0.05;
  const Square square = CellWindow(scene).square;
  return {square, std::min(map_samples(square.size_m, step_m), max_samples)};
}

GroundGrid tint_grid(const scene::Scene& scene) {
  constexpr int steps_of_patch = 8;
  const Square square = CellWindow(scene).square;
  const double max = is_large(scene) ? max_samples : 4097.0;
  const double samples = std::round(square.size_m / (scene.grass.patch_m / steps_of_patch)) + 1.0;
  return {square, static_cast<int>(std::min(samples, max))};
}

int cover_samples(const scene::Scene& scene) {
  constexpr int unit = 16;
  return std::max(64, whole_grid(scene).samples / 2 / unit * unit);
}

}  // namespace wold::place
