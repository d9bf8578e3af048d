#pragma once

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "light/daylight.h"

namespace wold::sky {

/// What a camera has before it that it must not burn out.
enum class Subject { meadow, clouds, snow };

/// Factor on every radiance as a camera's meter sets it: pi times how a white card in the open is
/// exposed, 1.6 for grass, 1.2 with clouds, 0.95 with snow; less with a low sun, so that the sky at
/// 20 degrees of elevation, and clouds that are lit there, come out as 0.9 at most.
double metered_gain(const light::Daylight& day, Subject subject);

/// The same for snow on slopes that are lit so: less where one in twenty would burn out, as slopes
/// towards a low sun do.
double snow_gain(const light::Daylight& day, const ColourMap& light);

/// Factor from 1/4 to 1 on a gain where the camera looks towards a low sun: as much less as it
/// takes that not more than a twentieth of the picture is sky that burns out, but two stops at
/// most. So it is with photographs of sunsets: land is dark in them. The sky is the clear one,
/// which changes evenly while clouds drift. `height_over_width`: of the picture.
double sunward_gain(const light::Daylight& day, const Heightfield& terrain,
                    const landscape::Camera& camera, double height_over_width, double gain);

/// Factor on that of a meter where the film's sun stands at `highest_deg` at most: a camera opens
/// as the sun sinks, but only half-way, as eyes adapt, so that evening is darker than day. After
/// sunset what is dim is shown dim in single pictures, too: by the ratio of keys 1.03 - 2 / (2 +
/// log10(L + 1)), L in cd/m2 (Krawczyk, Myszkowski and Seidel 2005, Perceptual effects in real-time
/// tone mapping). From the
/// illuminance under a clear sky (Seidelmann 1992, Explanatory supplement to the Astronomical
/// Almanac). Both from -5 to 90 degrees.
double dusk_gain(double sun_elevation_deg, double highest_deg);

}  // namespace wold::sky
