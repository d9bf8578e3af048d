#pragma once

#include "scene/scene.h"
#include "scene/shots.h"

namespace wold::scene {

/// Whether frames have suns of their own.
bool sun_moves(const Scene& scene);

/// The sun at a moment of a film without shots, `time` of the way from its first frame to its last,
/// in [0, 1]. In a season it stands where it is seen at sun.time on that day, between days in
/// between; otherwise it moves evenly to sun.end, by the shorter way around, or stands still.
Sun sun_at(const Scene& scene, double time);

/// The sun of a frame (from 1). In a season of shots it stands where it is seen at that moment of
/// that day; in any other film of shots it moves evenly to sun.end while the scene's clock goes
/// from the earliest moment of all shots to the latest.
Sun sun_of_frame(const Scene& scene, int frame);

/// The sun `way`, in [0, 1], from a take's first frame to its last: between frames it moves evenly.
Sun sun_on_way(const Scene& scene, const Take& take, double way);

}  // namespace wold::scene
