#include "place/cell_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "place/view.h"
#include "scene/shots.h"

namespace wold::place {
namespace {

/// Along a side; more cells than this squared no renderer places.
constexpr int max_patches = 2000;

constexpr double edge_fraction = 0.1;  ///< of half the window, where grass fades

glm::dvec2 way_end_m(const scene::Camera& camera) {
  if (camera.eye_end.size() < 2) return {camera.eye_m[0], camera.eye_m[1]};
  return {camera.eye_end[0], camera.eye_end[1]};
}

/// The least rectangle with sides along the axes that holds the ways of all cameras.
struct Ways {
  explicit Ways(const std::vector<scene::Camera>& cameras) {
    for (const scene::Camera& camera : cameras)
      for (const glm::dvec2& at_m :
           {glm::dvec2(camera.eye_m[0], camera.eye_m[1]), way_end_m(camera)}) {
        low_m = glm::min(low_m, at_m);
        high_m = glm::max(high_m, at_m);
      }
  }

  glm::dvec2 low_m = glm::dvec2(std::numeric_limits<double>::infinity()), high_m = -low_m;
};

/// So many cells hold the cameras' ways and all grass about it that stands, or as many as there may
/// be.
int wanted_cells(const scene::Scene& scene, double way_m) {
  const double size_m = (way_m + 2.0 * farthest_standing_m(scene)) / (1.0 - edge_fraction);
  const double cells = std::ceil(size_m / scene.grass.patch_m) + 2.0;
  return static_cast<int>(std::min({cells, 1.0 * max_patches, 1.0 * cells_per_side(scene)}));
}

}  // namespace

int cells_per_side(const scene::Scene& scene) {
  return static_cast<int>(std::floor(scene.terrain.size_m / scene.grass.patch_m + 1e-9));
}

bool is_large(const scene::Scene& scene) {
  constexpr double large_m = 120.0;
  return scene.terrain.size_m > large_m || cells_per_side(scene) > max_patches;
}

CellWindow::CellWindow(const scene::Scene& scene)
    : per_side(cells_per_side(scene)),
      square{.size_m = scene.terrain.size_m},
      open_low_m_(-std::numeric_limits<double>::infinity()),
      open_high_m_(std::numeric_limits<double>::infinity()) {
  if (!is_large(scene)) return;
  const int whole = per_side;
  const double patch_m = scene.grass.patch_m;
  const Ways ways(scene::cameras_of(scene));
  per_side = wanted_cells(scene, glm::distance(ways.low_m, ways.high_m));
  const glm::ivec2 middle(glm::floor(0.5 * (ways.low_m + ways.high_m) / patch_m));
  first = glm::clamp(middle - per_side / 2, glm::ivec2(0), glm::ivec2(whole - per_side));
  square = {glm::dvec2(first) * patch_m, per_side * patch_m};
  for (int axis = 0; axis < 2; ++axis) {
    if (first[axis] > 0) open_low_m_[axis] = square.corner_m[axis];
    if (first[axis] + per_side < whole) open_high_m_[axis] = square.corner_m[axis] + square.size_m;
  }
}

double CellWindow::outside_fraction(const glm::dvec2& at_m) const {
  const glm::dvec2 inside_m = glm::min(at_m - open_low_m_, open_high_m_ - at_m);
  const double relative = std::min(inside_m.x, inside_m.y) / (0.5 * edge_fraction * square.size_m);
  return relative >= 1.0 ? 0.0 : 1.0 - glm::smoothstep(0.0, 1.0, relative);
}

}  // namespace wold::place
