#pragma once

#include "snow/weather.h"

namespace wold::snow {

/// How wet the ground is at a time (since the first frame) and height, in [0, 1): 1 - exp(-w / 0.5
/// mm), where w is the water that lies on it. Rain brings it, and a fraction of it that is the same
/// in any time soaks away and dries, to 1/e in three hours: after t of rain R it is R 3 h (1 -
/// exp(-t / 3 h)). Rain of the last day counts, as far as the weather had lasted.
double ground_wetness(const Weather& weather, double time_s, double height_m);

/// Diffuse albedo of a rough surface of albedo `dry` in [0, 1] under a film of water: much of the
/// light that the surface sends up is thrown back by the film's upper side, and the ground gets it
/// once more (Lekner and Dorf 1988, Why some things are darker when wet, Applied Optics 27:1278).
/// Soil is about half as bright as dry. The 2 % that the film itself mirrors are left out.
double wet_albedo(double dry);

}  // namespace wold::snow
