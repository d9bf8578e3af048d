#include "place/ground_grids.h"

#include <algorithm>
#include <cmath>

#include "place/cell_window.h"
#include "place/view.h"

namespace wold::place {
namespace {

constexpr double finest_step_m = 0.01;
constexpr double side_ratio = 0.25;
constexpr double ahead = 0.3;  ///< of a square's side, from the eye to its middle
constexpr int max_samples = 2049;

/// Along a side, so that a step covers two and a half pixels at most where it is a fifth of the
/// side away.
double needed_samples(const scene::Scene& scene) {
  constexpr double samples_per_pixel = 2.0;
  return std::ceil(samples_per_pixel * pixels_per_radian(scene)) + 1.0;
}

int picture_samples(const scene::Scene& scene) {
  return static_cast<int>(std::clamp<double>(needed_samples(scene), 65, max_samples));
}

/// Level direction of view; none when the camera looks straight down.
glm::dvec2 ahead_of(const landscape::Camera& camera) {
  const glm::dvec2 way_m(camera.target_m - camera.eye_m);
  const double length_m = glm::length(way_m);
  return length_m > 0.0 ? way_m / length_m : glm::dvec2(0.0);
}

}  // namespace

GroundGrid whole_grid(const scene::Scene& scene) {
  return {{.size_m = scene.terrain.size_m}, picture_samples(scene)};
}

GroundGrid picture_grid(const scene::Scene& scene) {
  constexpr double usual_step_m = 0.03, min_step_m = 0.005;
  const double size_m = scene.terrain.size_m;
  const double samples = std::clamp<double>(
      needed_samples(scene), map_samples(size_m, usual_step_m), map_samples(size_m, min_step_m));
  return {{.size_m = size_m}, static_cast<int>(samples)};
}

std::vector<GroundGrid> detail_grids(const scene::Scene& scene, const landscape::Camera& camera) {
  std::vector<GroundGrid> grids;
  if (!is_large(scene)) return grids;
  GroundGrid grid = whole_grid(scene);
  while (grid.step_m() > finest_step_m) {
    grid.square.size_m *= side_ratio;
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

int cover_samples(const scene::Scene& scene) {
  constexpr int unit = 16;
  return std::max(64, picture_samples(scene) / 2 / unit * unit);
}

}  // namespace wold::place
