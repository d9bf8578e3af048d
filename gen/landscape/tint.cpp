#include "landscape/tint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "scene/key_frames.h"

namespace wold::landscape {
namespace {

/// The key frame of every cell of the terrain, row by row; -1 where none stands.
std::vector<int> key_frames(std::span<const CellChoice> choices, int per_side) {
  std::vector<int> frames(static_cast<std::size_t>(per_side * per_side), -1);
  for (const CellChoice& choice : choices)
    frames[static_cast<std::size_t>(choice.cell.y * per_side + choice.cell.x)] = choice.key_frame;
  return frames;
}

}  // namespace

ColourMap weathering_tint(const scene::Scene& scene, int frame, std::span<const CellChoice> choices,
                          const GrassColour& colour) {
  constexpr int samples_per_cell = 8;
  const int per_side = cells_per_side(scene);
  const std::vector<int> frames = key_frames(choices, per_side);
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
      const int key_frame = frames[static_cast<std::size_t>(cell.y * per_side + cell.x)];
      if (key_frame < 0) continue;
      const double shown = degrees[static_cast<std::size_t>(key_frame)];
      const glm::vec3 wanted = colour(local_weathering(scene, at_m, frame));
      constexpr glm::vec3 least(1e-3F);  // a channel may be empty
      tint.at(i, j) =
          glm::clamp(glm::max(wanted, least) / glm::max(colour(shown), least), 0.5F, 2.0F);
    }
  });
  return tint;
}

}  // namespace wold::landscape
