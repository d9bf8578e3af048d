#include "meadow/cell_lattice.h"

#include <cmath>

#include "core/random.h"
#include "place/cell_window.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

/// Between the places, in cells, at which the height of a row is drawn: as short as leaves slopes,
/// 0.134 at most, and gaps between straight pieces small.
constexpr double wave_cells = 14.0;

/// What patches of two rows leave free between them, in sides of cells: as much as straight pieces
/// would cross at most. In a renderer each sliver of two cells costs as much as a cell.
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
      are_squares_(scene::has_hair(scene) || !scene.grass.from_texel.empty() ||
                   place::cells_per_side(scene) == 1) {}

double CellLattice::row_shift(int row) const { return are_squares_ ? 0.0 : drawn(rows_, row); }

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

CellGround CellLattice::ground(const glm::ivec2& cell) const {
  const double x_m = (cell.x + 0.5 + row_shift(cell.y)) * patch_m_;
  const Wave here = wave(x_m);
  return {{x_m, (cell.y + 0.5 + here.height) * patch_m_}, patch_m_, here.slope};
}

void CellLattice::place_patch(landscape::CellPose& pose) const {
  if (are_squares_) return;
  const CellGround here = ground(pose.cell);
  pose.shift_m = here.middle_m - (glm::dvec2(pose.cell) + 0.5) * patch_m_;
  pose.shear = here.shear;
  pose.north_stretch = 1.0 - between_rows;
}

glm::ivec2 CellLattice::cell_at(const glm::dvec2& at_m) const {
  const double straight_m = at_m.y - patch_m_ * wave(at_m.x).height;
  const auto row = static_cast<int>(std::floor(straight_m / patch_m_));
  return {static_cast<int>(std::floor(at_m.x / patch_m_ - row_shift(row))), row};
}

}  // namespace wold::meadow
