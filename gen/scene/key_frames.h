#pragma once

#include <vector>

#include "scene/parts.h"

namespace wold::scene {

/// The weathering degrees for which patches are made: grass.key_frames, or, when that is empty,
/// equal steps from 0 to 1: twelve, as in [TVT] (figure 2), or as many more, up to 48, as it
/// takes to make none longer than the film's shortest. A patch then changes in small steps from
/// frame to frame, not in one jump after several frames. A shot in which less changes than the
/// smallest step does not count.
std::vector<double> key_frames(const MeadowPart& meadow);

}  // namespace wold::scene
