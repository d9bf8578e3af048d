#include "meadow/cell_lattice.h"

#include <cmath>

#include "core/random.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

/// Between the places, in cells, at which the height of a row is drawn: as short as leaves slopes,
/// 0.134 at most, and gaps between straight pieces small.
constexpr double wave_cells = 14.0;

/// Rows bend, so straight pieces of two rows would cross by so much of a cell's side at most: they
/// keep apart. In a renderer each sliver of two cells costs as much as a cell.
constexpr double between_rows = 0.004;

/// In [-1/2, 1/2).
double drawn(std::uint64_t key, double number) {
  const auto place = static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
  return random_uniform({key, place}) - 0.5;
}

}  // namespace

CellLattice::CellLattice(const scene::Scene& scene)
    : patch_m_(scene.grass.patch_m),
      rows_(random_bits({scene.seed, key_of("cell"), key_of("rows")})),
      waves_(random_bits({scene.seed, key_of("cell"), key_of("waves")})),
      are_squares_(scene::has_hair(scene)) {}

double CellLattice::row_begins_m(int row) const {
  return are_squares_ ? 0.0 : patch_m_ * drawn(rows_, row);
}

CellLattice::Wave CellLattice::wave(double x_m) const {
  if (are_squares_) return {};
  const double length_m = wave_cells * patch_m_;
  const double before = std::floor(x_m / length_m);
  const double t = x_m / length_m - before;
  const double low = drawn(waves_, before), rise = drawn(waves_, before + 1.0) - low;
  // [Perlin2002]'s quintic fade: rows bend without a corner.
  return {low + rise * t * t * t * (t * (6.0 * t - 15.0) + 10.0),
          rise * 30.0 * t * t * (1.0 - t) * (1.0 - t) / wave_cells};
}

glm::dvec2 CellLattice::shift_m(const glm::ivec2& cell) const {
  const double east_m = row_begins_m(cell.y);
  return {east_m, patch_m_ * wave((cell.x + 0.5) * patch_m_ + east_m).height};
}

double CellLattice::shear(const glm::ivec2& cell) const {
  return wave((cell.x + 0.5) * patch_m_ + row_begins_m(cell.y)).slope;
}

void CellLattice::lay(landscape::CellPose& pose) const {
  if (are_squares_) return;
  pose.shift_m = shift_m(pose.cell);
  pose.shear = shear(pose.cell);
  pose.north = 1.0 - between_rows;
}

glm::dvec2 CellLattice::place_m(const glm::ivec2& cell, const glm::dvec2& fraction) const {
  const glm::dvec2 from_middle_m = (fraction - 0.5) * patch_m_;
  return (glm::dvec2(cell) + 0.5) * patch_m_ + shift_m(cell) + from_middle_m +
         glm::dvec2(0.0, shear(cell) * from_middle_m.x);
}

glm::ivec2 CellLattice::cell_at(const glm::dvec2& at_m) const {
  const double straight_m = at_m.y - patch_m_ * wave(at_m.x).height;
  const auto row = static_cast<int>(std::floor(straight_m / patch_m_));
  return {static_cast<int>(std::floor((at_m.x - row_begins_m(row)) / patch_m_)), row};
}

}  // namespace wold::meadow
