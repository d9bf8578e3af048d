#include "terrain/still_water.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

namespace wold::terrain {
namespace {

/// Whole cells whose neighbours to all sides, this far away, belong to the same set.
constexpr int half_block = 1, half_large_block = 3;

class Cells {
 public:
  explicit Cells(const CellBlock& block) : block_(block), lake_(block.values.size(), unseen) {}

  /// The cells of that value that hang together with one, which are taken.
  std::vector<glm::ivec2> take_level(const glm::ivec2& first) {
    const double level = value(first);
    std::vector<glm::ivec2> level_cells = {first};
    mark(first, taken);
    for (std::size_t next = 0; next < level_cells.size(); ++next)
      for (const glm::ivec2 side : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const glm::ivec2 cell = level_cells[next] + side;
        if (!is_inside(cell) || number(cell) != unseen || value(cell) != level) continue;
        mark(cell, taken);
        level_cells.push_back(cell);
      }
    return level_cells;
  }

  bool is_inside(const glm::ivec2& cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < block_.size.x && cell.y < block_.size.y;
  }
  bool is_unseen(const glm::ivec2& cell) const { return number(cell) == unseen; }
  double value(const glm::ivec2& cell) const { return block_.values[index(cell)]; }
  void mark(const glm::ivec2& cell, int lake) { lake_[index(cell)] = lake; }

  /// Whether all cells up to so many away have one's value.
  bool is_level_around(const glm::ivec2& cell, int away) const {
    for (int y = -away; y <= away; ++y)
      for (int x = -away; x <= away; ++x)
        if (!is_inside(cell + glm::ivec2(x, y)) || value(cell + glm::ivec2(x, y)) != value(cell))
          return false;
    return true;
  }

  /// The number of each cell's lake, land being -1.
  std::vector<int> lakes() && {
    std::ranges::replace_if(
        lake_, [](int lake) { return lake < 0; }, -1);
    return std::move(lake_);
  }

 private:
  static constexpr int unseen = -2, taken = -1;

  std::size_t index(const glm::ivec2& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(block_.size.x) +
           static_cast<std::size_t>(cell.x);
  }
  int number(const glm::ivec2& cell) const { return lake_[index(cell)]; }

  const CellBlock& block_;
  std::vector<int> lake_;
};

/// How the land about a level surface lies, by the sides of its cells.
struct Shore {
  int sides = 0, lower = 0;
  int unknown = 0;  ///< where the block ends
  double mean_rise = 0.0;
};

Shore shore_of(const Cells& cells, const std::vector<glm::ivec2>& level_cells) {
  Shore shore;
  const double level = cells.value(level_cells.front());
  for (const glm::ivec2& cell : level_cells)
    for (const glm::ivec2 side : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      if (!cells.is_inside(cell + side)) {
        ++shore.unknown;
        continue;
      }
      const double rise = cells.value(cell + side) - level;
      if (std::isnan(rise) || rise == 0.0) continue;
      ++shore.sides;
      shore.lower += rise < 0.0 ? 1 : 0;
      shore.mean_rise += rise;
    }
  shore.mean_rise /= std::max(shore.sides, 1);
  return shore;
}

/// The step of a model whose values are whole numbers, 0 of any other.
double step_of(const CellBlock& block) {
  return std::ranges::all_of(
             block.values,
             [](double value) { return std::isnan(value) || value == std::rint(value); })
             ? 1.0
             : 0.0;
}

bool is_lake(const Cells& cells, const std::vector<glm::ivec2>& level_cells, double cell_m,
             double step) {
  constexpr std::size_t least_cells = 16, least_of_terrace = 200;
  constexpr double least_m2 = 400.0, outlet = 0.05;
  const auto area_m2 = cell_m * cell_m * static_cast<double>(level_cells.size());
  if (level_cells.size() < least_cells || area_m2 < least_m2) return false;
  const Shore shore = shore_of(cells, level_cells);
  if (shore.sides == 0 || shore.lower > outlet * shore.sides) return false;
  const bool may_be_terrace = shore.mean_rise < 2.0 * step;
  if (may_be_terrace && level_cells.size() < least_of_terrace) return false;
  const bool is_sea = cells.value(level_cells.front()) == 0.0;
  if (may_be_terrace && !is_sea && shore.unknown > outlet * shore.sides) return false;
  return std::ranges::any_of(level_cells, [&](const glm::ivec2& cell) {
    return cells.is_level_around(cell, may_be_terrace ? half_large_block : half_block);
  });
}

}  // namespace

StillWater still_water(const CellBlock& block, double cell_m) {
  StillWater water;
  Cells cells(block);
  const double step = step_of(block);
  for (int y = 0; y < block.size.y; ++y)
    for (int x = 0; x < block.size.x; ++x) {
      const glm::ivec2 first(x, y);
      if (!cells.is_unseen(first) || std::isnan(cells.value(first))) continue;
      const std::vector<glm::ivec2> level_cells = cells.take_level(first);
      if (!is_lake(cells, level_cells, cell_m, step)) continue;
      for (const glm::ivec2& cell : level_cells)
        cells.mark(cell, static_cast<int>(water.levels.size()));
      water.levels.push_back(cells.value(first));
    }
  water.lake = std::move(cells).lakes();
  return water;
}

}  // namespace wold::terrain
