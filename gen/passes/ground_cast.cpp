#include "passes/ground_cast.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wold::passes {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Span {
  double from_m;
  double to_m;
};

/// The part of a ray's way between two planes across an axis.
Span between(double low, double high, double eye, double direction) {
  if (direction == 0.0) return low <= eye && eye <= high ? Span{-infinite, infinite} : Span{1, 0};
  const double a = (low - eye) / direction, b = (high - eye) / direction;
  return {std::min(a, b), std::max(a, b)};
}

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

}  // namespace

/// What a ray knows while it goes through the tree.
struct GroundCast::Ray {
  glm::dvec3 eye_m;
  glm::dvec3 direction;
  int side = 0;  ///< 1 while it is above the ground, -1 below, 0 before that is known
  double met_m = infinite;

  double height_m(double at_m) const { return eye_m.z + at_m * direction.z; }
  /// Whether it has changed sides, and remembers the first one.
  bool is_now(int now) {
    if (side == 0) side = now;
    return now != 0 && now != side;
  }
};

GroundCast::GroundCast(const Heightfield& terrain)
    : terrain_(terrain), cells_(terrain.samples() - 1) {
  levels_.push_back(finest());
  while (levels_.back().columns > 1) levels_.push_back(coarser(levels_.back()));
}

GroundCast::Level GroundCast::finest() const {
  Level level{cells_, {}};
  for (int j = 0; j < cells_; ++j)
    for (int i = 0; i < cells_; ++i) {
      const auto [low, high] = std::minmax({terrain_.at(i, j), terrain_.at(i + 1, j),
                                            terrain_.at(i, j + 1), terrain_.at(i + 1, j + 1)});
      level.squares.push_back({low, high});
    }
  return level;
}

GroundCast::Level GroundCast::coarser(const Level& finer) {
  const int columns = (finer.columns + 1) / 2;
  const Heights none{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
  Level level{columns, std::vector(static_cast<std::size_t>(columns * columns), none)};
  for (int j = 0; j < finer.columns; ++j)
    for (int i = 0; i < finer.columns; ++i) {
      const Heights& part = finer.squares[static_cast<std::size_t>(j * finer.columns + i)];
      Heights& whole = level.squares[static_cast<std::size_t>(j / 2 * columns + i / 2)];
      whole = {std::min(whole.low, part.low), std::max(whole.high, part.high)};
    }
  return level;
}

double GroundCast::distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction) const {
  const Heights& all = levels_.back().squares.front();
  const Span in_height = between(all.low - 1.0, all.high + 1.0, eye_m.z, direction.z);
  Ray ray{eye_m, direction};
  meets(ray, levels_.size() - 1, glm::ivec2(0), std::max(0.0, in_height.from_m), in_height.to_m);
  return ray.met_m;
}

bool GroundCast::meets(Ray& ray, std::size_t level, const glm::ivec2& square, double from_m,
                       double to_m) const {
  const int columns = levels_[level].columns;
  if (square.x >= columns || square.y >= columns) return false;
  for (int axis = 0; axis < 2; ++axis) {
    const int side = 1 << level;
    const double low = terrain_.corner_m()[axis] + square[axis] * side * terrain_.step_m();
    const double high =
        terrain_.corner_m()[axis] + std::min((square[axis] + 1) * side, cells_) * terrain_.step_m();
    const Span span = between(low, high, ray.eye_m[axis], ray.direction[axis]);
    from_m = std::max(from_m, span.from_m);
    to_m = std::min(to_m, span.to_m);
  }
  if (!(from_m <= to_m)) return false;
  const Heights& heights =
      levels_[level].squares[static_cast<std::size_t>(square.y * columns + square.x)];
  const auto [lowest, highest] = std::minmax({ray.height_m(from_m), ray.height_m(to_m)});
  if (lowest > heights.high || highest < heights.low) {
    if (!ray.is_now(lowest > heights.high ? 1 : -1)) return false;
    ray.met_m = from_m;
    return true;
  }
  if (level == 0) return meets_cell(ray, square, from_m, to_m);
  const glm::ivec2 far(ray.direction.x < 0.0 ? 0 : 1, ray.direction.y < 0.0 ? 0 : 1);
  const glm::ivec2 near = 1 - far;
  for (const glm::ivec2& child : {near, {far.x, near.y}, {near.x, far.y}, far})
    if (meets(ray, level - 1, 2 * square + child, from_m, to_m)) return true;
  return false;
}

bool GroundCast::meets_cell(Ray& ray, const glm::ivec2& cell, double from_m, double to_m) const {
  const auto place = [&](double at_m) {
    const glm::dvec2 world_m = glm::dvec2(ray.eye_m) + at_m * glm::dvec2(ray.direction);
    return (world_m - terrain_.corner_m()) / terrain_.step_m() - glm::dvec2(cell);
  };
  const auto east_of_diagonal = [&](double at_m) { return place(at_m).x - place(at_m).y; };
  const double first = east_of_diagonal(from_m), last = east_of_diagonal(to_m);
  const bool crosses = sign(first) * sign(last) < 0;
  const double middle_m = crosses ? std::lerp(from_m, to_m, first / (first - last)) : to_m;
  for (const Span& part : {Span{from_m, middle_m}, Span{middle_m, to_m}}) {
    const bool is_south_eastern = east_of_diagonal(0.5 * (part.from_m + part.to_m)) > 0.0;
    const auto gap_m = [&](double at_m) {
      return ray.height_m(at_m) - plane_m(cell, is_south_eastern, place(at_m));
    };
    const double before = gap_m(part.from_m), after = gap_m(part.to_m);
    if (ray.is_now(sign(before))) {
      ray.met_m = part.from_m;
      return true;
    }
    if (ray.is_now(sign(after))) {
      ray.met_m = std::lerp(part.from_m, part.to_m, before / (before - after));
      return true;
    }
  }
  return false;
}

double GroundCast::plane_m(const glm::ivec2& cell, bool is_south_eastern,
                           const glm::dvec2& at) const {
  const double low{terrain_.at(cell.x, cell.y)}, high{terrain_.at(cell.x + 1, cell.y + 1)};
  if (is_south_eastern) {
    const double corner{terrain_.at(cell.x + 1, cell.y)};
    return low + at.x * (corner - low) + at.y * (high - corner);
  }
  const double corner{terrain_.at(cell.x, cell.y + 1)};
  return low + at.y * (corner - low) + at.x * (high - corner);
}

glm::dvec3 GroundCast::normal(const glm::dvec2& at_m) const {
  const glm::dvec2 place = (at_m - terrain_.corner_m()) / terrain_.step_m();
  const glm::ivec2 cell = glm::clamp(glm::ivec2(glm::floor(place)), 0, cells_ - 1);
  const glm::dvec2 within = place - glm::dvec2(cell);
  const bool is_south_eastern = within.x > within.y;
  const auto height_m = [&](const glm::dvec2& at) { return plane_m(cell, is_south_eastern, at); };
  const double here = height_m({0, 0});
  const glm::dvec2 rise = glm::dvec2(height_m({1, 0}) - here, height_m({0, 1}) - here);
  return glm::normalize(glm::dvec3(-rise / terrain_.step_m(), 1.0));
}

}  // namespace wold::passes
