#include "light/sunlight.h"

#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "core/elementary.h"

namespace wold::light {
namespace {

constexpr double extraterrestrial_klx = 130.0;  // between the 127.5 and 133.1 of the literature
constexpr double sun_temperature_K = 5778.0;

double lobe(double wavelength_nm, double centre_nm, double left_per_nm, double right_per_nm) {
  const double from_centre_nm = wavelength_nm - centre_nm;
  const double t = from_centre_nm * (from_centre_nm < 0.0 ? left_per_nm : right_per_nm);
  return math::exp(-0.5 * t * t);
}

/// CIE 1931 observer by the multi-lobe fit of Wyman, Sloan and Shirley 2013 (JCGT 2:2, table 1).
glm::dvec3 observer(double nm) {
  return {0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
              0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
          0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
          1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

/// Planck's law up to a factor.
double sun_spectrum(double nm) {
  constexpr double second_radiation_constant_nm_K = 1.438777e7;
  return math::pow(nm / 500.0, -5.0) /
         (math::exp(second_radiation_constant_nm_K / (nm * sun_temperature_K)) - 1.0);
}

/// Optical air mass (Kasten 1966).
double air_mass(double elevation_rad) {
  const double zenith_deg = 90.0 - elevation_rad * 180.0 / std::numbers::pi;
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
    const glm::dvec3 seen = sun_spectrum(nm) * observer(nm);
    xyz += seen * transmittance(nm, mass, turbidity);
    above += seen.y;
  }
  return srgb_from_xyz(xyz * (extraterrestrial_klx / above));
}

glm::dvec3 rgb_from_xyY(double x, double y, double luminance) {
  return srgb_from_xyz(glm::dvec3(x / y, 1.0, (1.0 - x - y) / y) * luminance);
}

}  // namespace wold::light
