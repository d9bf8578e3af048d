#include "landscape/tint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "scene/key_frames.h"

namespace wold::landscape {
namespace {

/// What every cell of the terrain shows, row by row; nothing where none stands.
std::vector<const CellChoice*> shown_cells(std::span<const CellChoice> choices, int per_side) {
  std::vector<const CellChoice*> shown(static_cast<std::size_t>(per_side * per_side), nullptr);
  for (const CellChoice& choice : choices)
    shown[static_cast<std::size_t>(choice.cell.y * per_side + choice.cell.x)] = &choice;
  return shown;
}

}  // namespace

ColourMap weathering_tint(const scene::Scene& scene, int frame, std::span<const CellChoice> choices,
                          double snow, const GrassColour& colour) {
  constexpr int samples_per_cell = 8;
  const int per_side = cells_per_side(scene);
  const std::vector<const CellChoice*> cells = shown_cells(choices, per_side);
  const std::vector<double> degrees = scene::key_frames(scene);
  constexpr double most_samples = 4097.0;
  const double step_m = scene.grass.patch_m / samples_per_cell;
  const double samples = std::round(scene.terrain.size_m / step_m) + 1.0;
  ColourMap tint(static_cast<int>(std::min(samples, most_samples)), scene.terrain.size_m,
                 glm::vec3(1.0F));
  parallel_for(static_cast<std::size_t>(tint.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < tint.samples(); ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * tint.step_m();
      const glm::ivec2 cell = glm::min(glm::ivec2(at_m / scene.grass.patch_m), per_side - 1);
      const CellChoice* choice = cells[static_cast<std::size_t>(cell.y * per_side + cell.x)];
      if (choice == nullptr) continue;
      const glm::vec3 shown = colour(degrees[static_cast<std::size_t>(choice->key_frame)],
                                     choice->state().snow_share());
      const glm::vec3 wanted = colour(local_weathering(scene, at_m, frame), snow);
      constexpr glm::vec3 least(1e-3F);  // a channel may be empty
      tint.at(i, j) = glm::clamp(glm::max(wanted, least) / glm::max(shown, least), 0.5F, 2.0F);
    }
  });
  return tint;
}

}  // namespace wold::landscape
