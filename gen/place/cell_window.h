#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::place {

/// Cells per side of the terrain: whole patches only.
int cells_per_side(const scene::Scene& scene);

/// Whether the terrain has more cells than are laid on it; its ground has finer pictures about the
/// camera.
bool is_large(const scene::Scene& scene);

/// Whether the terrain is so wide, over 120 m, that features of one size would look like camouflage
/// on it: its meadow differs from place to place in all sizes.
bool is_wide(const scene::Scene& scene);

/// Where cells are laid, the same in all frames: on the whole terrain where at most 2000 patches
/// lie along a side; on a larger one within a square about the middle of the camera's way, as far
/// as grass can stand or as many.
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
