#pragma once

#include <vector>

#include "place/cell_window.h"
#include "scene/scene.h"

namespace wold::meadow {

/// Which of a mixture's patches a cell has, and how it is turned.
struct CellTexel {
  int variant = 0;  ///< from 0 to below grass.variants
  int turn = 0;     ///< quarter-turns counter-clockwise, seen from above, from 0 to 3
};

/// Those of every cell of the window, row by row from the south-west corner. Each looks at its
/// western neighbour and at those on which its southern side lies, but for its ends, and is one of
/// those that look least like them, by keyed choice.
std::vector<CellTexel> choose_texels(const scene::Scene& scene, const place::CellWindow& window);

}  // namespace wold::meadow
