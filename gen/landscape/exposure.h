#pragma once

#include "light/daylight.h"

namespace wold::landscape {

/// Factor on every radiance as a camera's meter sets it: pi times how a white card in the open is
/// exposed, 1.6 or, in a scene with clouds, 1.2; less with a low sun, so that the sky at 20 degrees
/// of elevation comes out as 0.9 at most.
double metered_gain(const light::Daylight& day, bool clouds);

}  // namespace wold::landscape
