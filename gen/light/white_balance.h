#pragma once

#include <glm/glm.hpp>

namespace wold::light {

/// What a camera divides all light by, channel by channel, where level ground is lit by `light`,
/// linear sRGB with positive channels: a white card there is shown with luminance 1, and as white
/// where that light has a colour temperature of up to 7000 K.
///
/// Automatic white balances reach from about 3000 to 7000 K (Canon, instruction manuals of EOS
/// cameras); noon, low sun and overcast sky are within. Bluer light, as dusk's, is balanced as if
/// it had 7000 K, by the ratio of CIE's daylights of the two temperatures (CIE 015:2018): the card
/// is shown blue.
glm::dvec3 camera_white(const glm::dvec3& light);

/// Correlated colour temperature in K of linear sRGB, from 3000 to 50 000 K
/// [HernandezAndres1999].
double colour_temperature_K(const glm::dvec3& rgb);

/// CIE's daylight of a correlated colour temperature in [4000, 25 000] K, which is clamped, as
/// linear sRGB of luminance 1.
glm::dvec3 daylight_colour(double temperature_K);

}  // namespace wold::light
