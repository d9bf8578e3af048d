#include "meadow/cell_texels.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "meadow/cell_lattice.h"
#include "meadow/cell_uniform.h"

namespace wold::meadow {
namespace {

/// How much two neighbours look alike: the same variant shows even when it is turned, and levels
/// that use but two turns undo a half-turn.
int likeness(const CellTexel& a, const CellTexel& b) {
  if (a.variant != b.variant) return 0;
  if (a.turn == b.turn) return 3;
  return a.turn % 2 == b.turn % 2 ? 2 : 1;
}

int likeness(const CellTexel& texel, const std::vector<CellTexel>& neighbours) {
  int sum = 0;
  for (const CellTexel& neighbour : neighbours) sum += likeness(texel, neighbour);
  return sum;
}

/// One of the texels that look least like the neighbours; `uniform` in [0, 1) chooses.
CellTexel unlike(const std::vector<CellTexel>& neighbours, int variants, double uniform) {
  std::vector<CellTexel> best = {CellTexel{}};
  int min = likeness(best.front(), neighbours);
  for (int k = 1; k < variants * 4; ++k) {
    const CellTexel candidate{k / 4, k % 4};
    const int sum = likeness(candidate, neighbours);
    if (sum < min) best.clear();
    min = std::min(min, sum);
    if (sum == min) best.push_back(candidate);
  }
  return best[static_cast<std::size_t>(uniform * static_cast<double>(best.size()))];
}

/// By how many columns those cells of a row lie to the east of a cell of the next row on which its
/// southern side lies, but for a fraction of that side at its ends: one or two.
std::vector<int> columns_below(const CellLattice& lattice, int row, double ends) {
  const double shift = lattice.row_shift(row) - lattice.row_shift(row - 1);
  const auto below = [&](double east) { return static_cast<int>(std::floor(shift + east)); };
  const int western = below(ends), eastern = below(1.0 - ends);
  return western == eastern ? std::vector{western} : std::vector{western, eastern};
}

}  // namespace

std::vector<CellTexel> choose_texels(const scene::Scene& scene, const place::CellWindow& window) {
  const CellLattice lattice(scene);
  // Two variants cannot differ from three neighbours: along a row one would see it most.
  const double ends = scene.grass.variants < 3 ? 0.25 : 0.02;
  const int per_side = window.per_side;
  std::vector<CellTexel> texels;
  texels.reserve(static_cast<std::size_t>(per_side) * static_cast<std::size_t>(per_side));
  for (int j = 0; j < per_side; ++j) {
    const std::vector<int> columns = columns_below(lattice, window.first.y + j, ends);
    for (int i = 0; i < per_side; ++i) {
      std::vector<CellTexel> neighbours;
      if (i > 0) neighbours.push_back(texels.back());
      for (const int column : columns) {
        const int below = i + column;
        if (j > 0 && below >= 0 && below < per_side)
          neighbours.push_back(texels[static_cast<std::size_t>((j - 1) * per_side + below)]);
      }
      const glm::ivec2 cell = window.first + glm::ivec2(i, j);
      texels.push_back(
          unlike(neighbours, scene.grass.variants, cell_uniform(scene.seed, cell, "texel")));
    }
  }
  return texels;
}

}  // namespace wold::meadow
