#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace wold::scene {

/// Scenes have a sun that stands this high at least, degrees: at dusk. It is night not much later.
inline constexpr double min_sun_elevation_deg = -4.0;

/// Where the centre of the sun's disc is seen from the ground.
struct SunPosition {
  double elevation_deg;  ///< above the level horizon, with refraction; -90 to 90
  double azimuth_deg;    ///< clockwise from north, [0, 360)
};

/// The sun seen at sea level in a standard atmosphere (1010 hPa, 10 degrees C), on a valid date of
/// the Gregorian calendar, hours_utc in [0, 24] after its midnight; latitude_deg in [-90, 90],
/// positive north; longitude_deg positive east, any turn. Within 0.02 degrees from 1950 to 2050.
/// Directly under the sun and at the poles azimuths are ill-defined; the poles' are the limit
/// along the given meridian. Source: Meeus, Astronomical Algorithms (2nd edition 1998), chapters
/// 25 (low accuracy), 28 and 16. Leaves out, as too small: UTC against dynamical time (0.001
/// degrees) and against UT1 (0.004), parallax (0.0025).
SunPosition sun_position(const std::chrono::year_month_day& date, double hours_utc,
                         double latitude_deg, double longitude_deg);

/// Year, month and day, three numbers, which may be no day of the calendar.
std::chrono::year_month_day date_of(const std::vector<std::int64_t>& numbers);

/// Where the scene's sun stands: at its date and place, or as given when it has no date. The date,
/// if any, is three numbers.
SunPosition sun_position(const Sun& sun);

}  // namespace wold::scene
