#pragma once

#include "scene/scene.h"

namespace wold::scene {

/// Whether frames have suns of their own.
bool sun_moves(const Scene& scene);

/// The sun at a moment of the film, `time` of the way from its first frame to its last, in [0, 1].
/// In a season it stands where it is seen at sun.time on that day, between days in between;
/// otherwise it moves evenly to sun.end, by the shorter way around, or stands still.
Sun sun_at(const Scene& scene, double time);

}  // namespace wold::scene
