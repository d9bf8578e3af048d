#pragma once

#include "landscape/landscape.h"

namespace wold::blender {

/// Cycles keeps the volumes that a ray is in on a stack of so many places, and leaves out what
/// finds none, without a word.
inline constexpr int volumes_on_a_stack = 32;
/// So many are near that: a neighbour's tips or another cloud, and some are missing.
inline constexpr int many_volumes = 24;

/// How many volumes lie over one place at most, along rays from the camera through every tenth
/// pixel or so: boxes of cells, or of their quarters, of which parts of a cell are shown; clouds;
/// fog, which is everywhere.
int deepest_volume_stack(const landscape::Landscape& landscape);

}  // namespace wold::blender
