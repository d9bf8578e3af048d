#include "meadow/tint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "meadow/cell_lattice.h"
#include "place/cell_window.h"
#include "scene/key_frames.h"

namespace wold::meadow {
namespace {

std::size_t place_of(const glm::ivec2& cell, const place::CellWindow& window) {
  const glm::ivec2 inside = cell - window.first;
  return static_cast<std::size_t>(inside.y) * window.per_side + inside.x;
}

/// What every cell of the window shows, row by row; nothing where none stands. What grows around
/// shrubs comes first.
std::vector<const CellChoice*> shown_cells(std::span<const CellChoice> choices,
                                           const place::CellWindow& window) {
  std::vector<const CellChoice*> shown(static_cast<std::size_t>(window.per_side * window.per_side),
                                       nullptr);
  for (const CellChoice& choice : choices) {
    const CellChoice*& first = shown[place_of(choice.cell, window)];
    if (first == nullptr) first = &choice;
  }
  return shown;
}

}  // namespace

ColourMap weathering_tint(const scene::Scene& scene, const place::Withering& withering, int frame,
                          std::span<const CellChoice> choices, double snow,
                          const GrassColour& colour, const GroundGrid& grid) {
  const place::CellWindow window(scene);
  const CellLattice lattice(scene);
  const std::vector<const CellChoice*> cells = shown_cells(choices, window);
  const std::vector<double> degrees = scene::key_frames(scene);
  ColourMap tint(grid.samples, grid.square, glm::vec3(1.0F));
  parallel_for(static_cast<std::size_t>(tint.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < tint.samples(); ++i) {
      const glm::dvec2 at_m = tint.place_m(i, j);
      const glm::ivec2 cell =
          glm::clamp(lattice.cell_at(at_m), window.first, window.first + window.per_side - 1);
      const CellChoice* choice = cells[place_of(cell, window)];
      if (choice == nullptr) continue;
      const glm::vec3 shown = colour(degrees[static_cast<std::size_t>(choice->key_frame)],
                                     choice->state().snow_fraction());
      const glm::vec3 wanted = colour(withering.at(at_m, frame), snow);
      constexpr glm::vec3 min(1e-3F);  // a channel may be empty
      tint.at(i, j) = glm::clamp(glm::max(wanted, min) / glm::max(shown, min), 0.5F, 2.0F);
    }
  });
  return tint;
}

}  // namespace wold::meadow
