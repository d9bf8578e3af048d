#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::place {

/// Cells per side of the terrain: whole patches only.
int cells_per_side(const scene::Scene& scene);

/// Whether the terrain is so large, over 120 m or 2000 patches a side, that one picture of its
/// ground would be too coarse before the camera, and features of one size would look like
/// camouflage: its ground has finer pictures about the camera, and its meadow differs from place to
/// place in all sizes.
bool is_large(const scene::Scene& scene);

/// Where cells are laid, the same in all frames: on the whole terrain; on a large one within a
/// square about the middle of the camera's way, as far as grass can stand or at most 2000 patches a
/// side.
struct CellWindow {
  explicit CellWindow(const scene::Scene& scene);

  glm::ivec2 first{0};  ///< its south-western cell
  int per_side = 0;
  Square square;  ///< on the ground; that of the terrain where that is covered

  /// How far grass is painted for the window's sake: 1 outside, 0 within nine tenths of the way to
  /// its borders; those that are the terrain's do not count.
  double outside_fraction(const glm::dvec2& at_m) const;

 private:
  glm::dvec2 open_low_m_;  ///< beyond which no cells are; infinite where the terrain ends
  glm::dvec2 open_high_m_;
};

}  // namespace wold::place
