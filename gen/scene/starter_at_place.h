#pragma once

#include <array>

#include "scene/starter.h"
#include "scene/starter_kinds.h"

namespace wold::scene {

/// Moves a scene to a longitude and latitude, degrees: its sun stands there as late in the day, and
/// south of the equator a season is half a year later.
void move_to(Scene& scene, const std::array<double, 2>& longitude_latitude_deg);

/// The starter with the ground of a real place instead of its own hill. Its grass is of three
/// tones, with bushes and flowers in it.
Starter at_place(Starter starter, const StarterPlace& place);

}  // namespace wold::scene
