#pragma once

#include <glm/glm.hpp>

#include "meadow/cell_lattice.h"
#include "place/cell_window.h"
#include "scene/scene.h"

namespace wold::meadow {

/// Where the shrubs of a cell stand, and how large they are.
struct ShrubPlace {
  glm::dvec2 shift_m{0.0};  ///< see CellPose
  double size = 1.0;        ///< over the patch's own, in all directions
};

/// The smallest and the largest ShrubPlace::size, whose logarithms are even between them: small
/// ones are many, as where shrubs of all ages stand. Shrubs cover as much ground in the mean as if
/// all had a size of 1.
inline constexpr double smallest_shrub = 0.45, largest_shrub = 1.68;

/// Anywhere in the cell is their middle, keyed by it: shrubs in rows would look planted. All of
/// their patch lies on the window.
ShrubPlace shrub_place(const scene::Scene& scene, const place::CellWindow& window,
                       const CellLattice& lattice, const glm::ivec2& cell);

}  // namespace wold::meadow
