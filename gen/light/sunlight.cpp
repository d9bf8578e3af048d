#include "light/sunlight.h"

#include <cmath>

#include "core/angle.h"
#include "core/colour.h"
#include "core/elementary.h"

namespace wold::light {
namespace {

constexpr double extraterrestrial_klx = 130.0;  // between the 127.5 and 133.1 of the literature
constexpr double sun_temperature_K = 5778.0;

/// Planck's law up to a factor.
double sun_spectrum(double nm) {
  constexpr double second_radiation_constant_nm_K = 1.438777e7;
  return math::pow(nm / 500.0, -5.0) /
         (math::exp(second_radiation_constant_nm_K / (nm * sun_temperature_K)) - 1.0);
}

/// Optical air mass (Kasten 1966).
double air_mass(double elevation_rad) {
  const double zenith_deg = 90.0 - degrees(elevation_rad);
  return 1.0 / (math::sin(elevation_rad) + 0.15 * math::pow(93.885 - zenith_deg, -1.253));
}

double transmittance(double nm, double mass, double turbidity) {
  const double um = nm / 1000.0;
  const double aerosol = 0.04608 * turbidity - 0.04586;
  return math::exp(-mass * (0.008735 * math::pow(um, -4.08) + aerosol * math::pow(um, -1.3)));
}

}  // namespace

glm::dvec3 direct_sunlight_klx(double elevation_rad, double turbidity) {
  const double mass = air_mass(elevation_rad);
  glm::dvec3 xyz(0.0);
  double above = 0.0;
  for (int nm = 380; nm <= 780; nm += 5) {
    const glm::dvec3 seen = sun_spectrum(nm) * observer_fit(nm);
    xyz += seen * transmittance(nm, mass, turbidity);
    above += seen.y;
  }
  return srgb_from_xyz(xyz * (extraterrestrial_klx / above));
}

glm::dvec3 rgb_from_xyY(double x, double y, double luminance) {
  return srgb_from_xyz(glm::dvec3(x / y, 1.0, (1.0 - x - y) / y) * luminance);
}

}  // namespace wold::light
