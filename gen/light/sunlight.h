#pragma once

#include <glm/glm.hpp>

namespace wold::light {

/// Luminous irradiance of a plane that faces the sun, in klx, as linear sRGB (luminance = the
/// visual irradiance), at sea level under a clear sky. Turbidity: Preetham's T, 2 clear to 10 hazy.
/// Source: Preetham, Shirley and Smits 1999, appendix: E0 exp(-m (0.008735 l^-4.08 + beta l^-1.3)),
/// l in um, beta = 0.04608 T - 0.04586, air mass m of Kasten 1966.
glm::dvec3 direct_sunlight_klx(double elevation_rad, double turbidity);

/// Linear sRGB of a colour given by CIE xy and luminance (IEC 61966-2-1); may be negative outside
/// the gamut.
glm::dvec3 rgb_from_xyY(double x, double y, double luminance);

}  // namespace wold::light
