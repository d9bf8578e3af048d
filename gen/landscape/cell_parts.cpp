#include "landscape/cell_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace wold::landscape {
namespace {

struct Rectangle {
  glm::dvec2 low_m{0.0};
  glm::dvec2 high_m{0.0};

  glm::dvec2 centre_m() const { return (low_m + high_m) / 2.0; }
};

/// z = height_m + dot(rise, at - the rectangle's centre).
struct Plane {
  double height_m = 0.0;
  glm::dvec2 rise{0.0};
};

/// Where the axes of a cell point to, as long as it stretches them.
struct Axes {
  explicit Axes(const CellPose& pose) {
    const auto placed = [&](const glm::dvec2& direction) {
      return pose.size *
             glm::dvec2(direction.x, pose.north_stretch * direction.y + pose.shear * direction.x);
    };
    x = placed(east_of(pose.turn));
    y = placed(left_of(east_of(pose.turn)));
  }

  glm::dvec2 x, y;
};

/// The ground that a part covers; of a sheared one, the rectangle around it.
Rectangle ground_of(const Part& part, double patch_m, const CellPose& pose) {
  const Axes axes(pose);
  const auto from_middle_m = [&](double x, double y) {
    return patch_m * ((x - 0.5) * axes.x + (y - 0.5) * axes.y);
  };
  const glm::dvec2 a = from_middle_m(part.low.x, part.low.y);
  const glm::dvec2 b = from_middle_m(part.high.x, part.low.y);
  const glm::dvec2 c = from_middle_m(part.high.x, part.high.y);
  const glm::dvec2 d = from_middle_m(part.low.x, part.high.y);
  const glm::dvec2 centre_m = middle_m(pose, patch_m);
  return {centre_m + glm::min(glm::min(a, b), glm::min(c, d)),
          centre_m + glm::max(glm::max(a, b), glm::max(c, d))};
}

/// How the ground rises, by least squares over places spread evenly.
glm::dvec2 rise_of(const Heightfield& terrain, const Rectangle& ground) {
  constexpr int per_side = 8;
  glm::dvec2 squares_m2(0.0), products_m2(0.0);
  for (int j = 0; j < per_side; ++j)
    for (int i = 0; i < per_side; ++i) {
      const glm::dvec2 fraction = (glm::dvec2(i, j) + 0.5) / double{per_side} - 0.5;
      const glm::dvec2 from_centre_m = fraction * (ground.high_m - ground.low_m);
      const glm::dvec2 at_m = ground.centre_m() + from_centre_m;
      squares_m2 += from_centre_m * from_centre_m;
      products_m2 += from_centre_m * double{terrain.sample(at_m.x, at_m.y)};
    }
  return products_m2 / squares_m2;
}

/// Both ends of a rectangle's side and the terrain's samples between them.
std::vector<double> corners_along(const Heightfield& terrain, const Rectangle& ground, int axis) {
  const double first_m = terrain.corner_m()[axis], step_m = terrain.step_m();
  const double low_m = ground.low_m[axis], high_m = ground.high_m[axis];
  std::vector<double> places_m = {low_m};
  for (double k = std::floor((low_m - first_m) / step_m) + 1.0; first_m + k * step_m < high_m; ++k)
    places_m.push_back(first_m + k * step_m);
  places_m.push_back(high_m);
  return places_m;
}

/// The plane under a rectangle and how far it leaves the ground.
std::pair<Plane, double> plane_under(const Heightfield& terrain, const Rectangle& ground) {
  const glm::dvec2 rise = rise_of(terrain, ground);
  const std::vector<double> rows_m = corners_along(terrain, ground, 1);
  double min_m = std::numeric_limits<double>::infinity();
  double max_m = -min_m;
  for (const double x : corners_along(terrain, ground, 0))
    for (const double y : rows_m) {
      const double above_m =
          double{terrain.sample(x, y)} - glm::dot(rise, glm::dvec2(x, y) - ground.centre_m());
      min_m = std::min(min_m, above_m);
      max_m = std::max(max_m, above_m);
    }
  return {{(min_m + max_m) / 2.0, rise}, (max_m - min_m) / 2.0};
}

/// A quarter of a quarter ... of a patch: which of `per_side` x `per_side`.
struct Quarter {
  glm::ivec2 place{0};
  int per_side = 1;
};

Part part_of(const Quarter& quarter, int voxels) {
  const int step = (voxels + 2) / quarter.per_side;
  const auto border = [&](int k) { return std::clamp((k * step - 1.0) / voxels, 0.0, 1.0); };
  const glm::ivec2& at = quarter.place;
  return {{border(at.x), border(at.y)}, {border(at.x + 1), border(at.y + 1)}};
}

std::array<Quarter, 4> quarters_of(const Quarter& whole) {
  std::array<Quarter, 4> quarters;
  for (int k = 0; k < 4; ++k)
    quarters[static_cast<std::size_t>(k)] = {2 * whole.place + glm::ivec2(k & 1, k >> 1),
                                             2 * whole.per_side};
  return quarters;
}

}  // namespace

glm::dvec2 east_of(int turn) {
  constexpr int cosines[] = {1, 0, -1, 0};
  return {cosines[turn & 3], cosines[(turn + 3) & 3]};
}

glm::dvec2 left_of(const glm::dvec2& direction) { return {-direction.y, direction.x}; }

glm::dvec2 middle_m(const CellPose& pose, double patch_m) {
  return (glm::dvec2(pose.cell) + 0.5) * patch_m + pose.shift_m;
}

double size_of(const glm::dmat4& world_from_cell) {
  return std::sqrt(std::abs(glm::determinant(glm::dmat2(world_from_cell))));
}

GroundFit fit_to_ground(const Heightfield& terrain, double patch_m, const CellPose& pose,
                        const Part& part) {
  const Rectangle ground = ground_of(part, patch_m, pose);
  const auto [plane, deviation_m] = plane_under(terrain, ground);
  const glm::dvec2& rise = plane.rise;
  const glm::dvec2 lean = pose.size * pose.lean;
  const Axes axes(pose);
  const glm::dvec2 origin_m = middle_m(pose, patch_m) - (axes.x + axes.y) * (patch_m / 2.0);
  const double z_m = plane.height_m + glm::dot(rise, origin_m - ground.centre_m());
  return {
      {glm::dvec4(axes.x, glm::dot(rise, axes.x), 0), glm::dvec4(axes.y, glm::dot(rise, axes.y), 0),
       glm::dvec4(lean, pose.size + glm::dot(rise, lean), 0), glm::dvec4(origin_m, z_m, 1)},
      deviation_m};
}

std::vector<PlacedPart> parts_on_ground(const Heightfield& terrain, double patch_m,
                                        const CellPose& pose, int voxels, double tolerance_m) {
  constexpr int max_per_side = 8;
  std::vector<PlacedPart> parts;
  std::vector<Quarter> todo = {{}};
  while (!todo.empty()) {
    const Quarter quarter = todo.back();
    todo.pop_back();
    const Part part = part_of(quarter, voxels);
    const GroundFit fit = fit_to_ground(terrain, patch_m, pose, part);
    if (fit.deviation_m <= tolerance_m || quarter.per_side == max_per_side)
      parts.push_back({part, fit.world_from_cell});
    else
      std::ranges::copy(quarters_of(quarter), std::back_inserter(todo));
  }
  return parts;
}

std::array<Part, 4> quarters_of_patch(int voxels) {
  std::array<Part, 4> parts;
  std::ranges::transform(quarters_of({}), parts.begin(),
                         [&](const Quarter& quarter) { return part_of(quarter, voxels); });
  return parts;
}

}  // namespace wold::landscape
